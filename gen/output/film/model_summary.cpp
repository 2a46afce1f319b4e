#include "film/model_summary.h"

#include <algorithm>
#include <utility>

#include "core/read_as.h"
#include "core/text.h"

namespace frond {

namespace {

/// Reads the tokens of a text, one after the other; nothing more after the first that is not as expected.
class TokenReader {
 public:
  explicit TokenReader(std::string_view text) : text_(text) {}

  bool expect(std::string_view word) { return good_ = next() == word && good_; }

  template <class Number>
  bool read(Number& number) {
    std::optional<Number> value = read_as<Number>(next());
    number = value.value_or(number);
    return good_ = good_ && value;
  }

 private:
  std::string_view next() {
    text_.remove_prefix(std::min(text_.find_first_not_of(" \n"), text_.size()));
    std::string_view word = text_.substr(0, text_.find_first_of(" \n"));
    text_.remove_prefix(word.size());
    return word;
  }

  std::string_view text_;
  bool good_ = true;
};

}  // namespace

std::string summary_text(const ModelSummary& summary) {
  std::string text = "surfels ";
  append_index(text, summary.surfels.size());
  for (const Surfel& c : summary.surfels) {
    char before = '\n';
    auto add = [&](float number, int decimals) {
      text += std::exchange(before, ' ');
      append(text, number, decimals);
    };
    for (float number : {c.at.x, c.at.y, c.at.z}) add(number, kSurfelDecimals);
    add(c.area, kSurfelAreaDecimals);
    for (float number : {c.wide, c.albedo.x, c.albedo.y, c.albedo.z, c.bulk}) add(number, kSurfelDecimals);
  }
  text += "\nfiles ";
  append_index(text, summary.parts.size());
  for (const auto& [file, parts] : summary.parts) {
    char before = '\n';
    auto add = [&](long long number) {
      text += std::exchange(before, ' ');
      append_integer(text, number);
    };
    add(file.first), add(file.second), add(static_cast<long long>(parts.size()));
    for (int part : parts) add(part);
  }
  return text + "\nend\n";
}

std::optional<ModelSummary> read_summary(std::string_view text) {
  ModelSummary summary;
  TokenReader tokens(text);
  std::size_t surfels = 0, files = 0;
  bool good = tokens.expect("surfels") && tokens.read(surfels);
  for (std::size_t i = 0; i < surfels && good; ++i) {
    Surfel& c = summary.surfels.emplace_back();
    for (float* number :
         {&c.at.x, &c.at.y, &c.at.z, &c.area, &c.wide, &c.albedo.x, &c.albedo.y, &c.albedo.z, &c.bulk})
      good = tokens.read(*number);
  }
  good = tokens.expect("files") && tokens.read(files);
  for (std::size_t i = 0; i < files && good; ++i) {
    std::pair<int, int> file;
    std::size_t count = 0;
    good = tokens.read(file.first) && tokens.read(file.second) && tokens.read(count);
    std::vector<int>& parts = summary.parts[file];
    for (std::size_t k = 0; k < count && good; ++k) good = tokens.read(parts.emplace_back());
  }
  return tokens.expect("end") ? std::optional(std::move(summary)) : std::nullopt;
}

}  // namespace frond
