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

void append_surfel(std::string& text, const Surfel& c) {
  char before = '\n';
  auto add = [&](float number, int decimals) {
    text += std::exchange(before, ' ');
    append(text, number, decimals);
  };
  for (float number : {c.at.x, c.at.y, c.at.z}) add(number, kSurfelDecimals);
  add(c.area, kSurfelAreaDecimals);
  for (float number : {c.wide, c.albedo.x, c.albedo.y, c.albedo.z, c.bulk}) add(number, kSurfelDecimals);
}

bool read_surfel(TokenReader& tokens, Surfel& c) {
  bool good = true;
  for (float* number :
       {&c.at.x, &c.at.y, &c.at.z, &c.area, &c.wide, &c.albedo.x, &c.albedo.y, &c.albedo.z, &c.bulk})
    good = tokens.read(*number);
  return good;
}

bool read_finer(TokenReader& tokens, std::vector<Surfel>& surfels) {
  std::size_t which = 0, count = 0;
  int halvings = 0;
  if (!tokens.read(which) || !tokens.read(halvings) || !tokens.read(count) || which >= surfels.size())
    return false;
  surfels[which].halvings = halvings;
  for (std::size_t k = 0; k < count; ++k) {
    Surfel& c = surfels[which].finer.emplace_back();
    int facing = 0;
    if (!read_surfel(tokens, c) || !tokens.read(facing)) return false;
    c.facing = static_cast<Facing>(facing);
  }
  return true;
}

}  // namespace

std::vector<int> ModelSummary::halvings() const {
  std::vector<int> list;
  for (const Surfel& surfel : surfels) list.push_back(surfel.halvings);
  return list;
}

std::string summary_text(const ModelSummary& summary) {
  std::string text = "surfels ";
  append_index(text, summary.surfels.size());
  for (const Surfel& c : summary.surfels) append_surfel(text, c);
  text += "\nfiner ";
  append_index(text, static_cast<std::size_t>(std::ranges::count_if(summary.surfels, &Surfel::halvings)));
  for (std::size_t i = 0; i < summary.surfels.size(); ++i) {
    const Surfel& c = summary.surfels[i];
    if (c.halvings == 0) continue;
    text += '\n', append_index(text, i);
    text += ' ', append_integer(text, c.halvings);
    text += ' ', append_index(text, c.finer.size());
    for (const Surfel& finer : c.finer) {
      append_surfel(text, finer);
      text += ' ', append_integer(text, finer.facing);
    }
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
  std::size_t surfels = 0, finer = 0, files = 0;
  bool good = tokens.expect("surfels") && tokens.read(surfels);
  for (std::size_t i = 0; i < surfels && good; ++i)
    good = read_surfel(tokens, summary.surfels.emplace_back());
  good = good && tokens.expect("finer") && tokens.read(finer);
  for (std::size_t i = 0; i < finer && good; ++i) good = read_finer(tokens, summary.surfels);
  good = good && tokens.expect("files") && tokens.read(files);
  for (std::size_t i = 0; i < files && good; ++i) {
    std::pair<int, int> file;
    std::size_t count = 0;
    good = tokens.read(file.first) && tokens.read(file.second) && tokens.read(count);
    std::vector<int>& parts = summary.parts[file];
    for (std::size_t k = 0; k < count && good; ++k) good = tokens.read(parts.emplace_back());
  }
  return good && tokens.expect("end") ? std::optional(std::move(summary)) : std::nullopt;
}

}  // namespace frond
