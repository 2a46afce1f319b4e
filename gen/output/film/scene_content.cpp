#include "film/scene_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "core/files.h"
#include "core/seed.h"
#include "images/png_samples.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigits = 16;  // of a name by content

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); }

/// The end of the word that begins there.
std::size_t word_end(std::string_view text, std::size_t at) {
  while (at < text.size() && in_word(text[at])) ++at;
  return at;
}

/// Where the digits of a name by content lie in a word: behind a line and before another or the end.
std::size_t digits_in(std::string_view word) {
  for (std::size_t at = word.find('_'); at != word.npos; at = word.find('_', at + 1)) {
    std::string_view rest = word.substr(at + 1, kDigits);
    bool ends =
        at + 1 + kDigits == word.size() || (at + 1 + kDigits < word.size() && word[at + 1 + kDigits] == '_');
    if (rest.size() == kDigits && ends && std::ranges::all_of(rest, is_digit)) return at + 1;
  }
  return word.npos;
}

/// The digits of a file's name; empty where it has none.
std::string digits_of(const std::string& name) {
  std::size_t at = digits_in(std::string_view(name).substr(0, name.find('.')));
  return at == name.npos ? "" : name.substr(at, kDigits);
}

/// A scene and what it is made of.
class Contents {
 public:
  Contents(const fs::path& folder) : folder_(folder) {
    for (const fs::path& file : files_in(folder)) there_.insert(file.filename().string());
  }

  Result<SceneContent> read(const std::vector<fs::path>& scenes) {
    std::vector<fs::path> to_read = scenes;
    while (!to_read.empty()) {
      fs::path file = to_read.back();
      to_read.pop_back();
      std::string name = file.filename().string();
      if (texts_.contains(name)) continue;
      Result<std::string> text = content_of(folder_ / file);
      if (!text) return text.errors();
      if (std::string digits = digits_of(name); !digits.empty()) groups_[digits].insert(name);
      std::string& kept = texts_[name] = std::move(*text);
      if (!name.ends_with(".png")) note_names(kept, to_read);
    }
    std::uint64_t sum = 0;
    for (const auto& [name, text] : texts_)
      if (digits_of(name).empty()) sum += number_of(name, "");
    return SceneContent{fmt::format("{:016x}", sum), std::move(words_)};
  }

 private:
  static Result<std::string> content_of(const fs::path& file) {
    Result<std::string> text = read_file(file);
    if (!text || file.extension() != ".png") return text;
    Result<PngSamples> samples = read_samples(*text);
    if (!samples) return Error{file.string(), samples.errors().front().what};
    return fmt::format("{} {} {} {} {}\n{}", samples->width, samples->height, samples->channels,
                       samples->bits, samples->gamma,
                       std::string(samples->data.begin(), samples->data.end()));
  }

  /// Notes the words of a text, and the files of the folder that it names.
  void note_names(std::string_view text, std::vector<fs::path>& named) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (!in_word(text[i])) continue;
      std::size_t end = word_end(text, i);
      std::string_view word = text.substr(i, end - i);
      if (end < text.size() && text[end] == '.' && !std::isdigit(static_cast<unsigned char>(word[0]))) {
        std::string name(text.substr(i, word_end(text, end + 1) - i));
        if (name.starts_with("RF")) name.erase(0, 2);  // POV-Ray's option for the file of its radiosity
        if (there_.contains(name)) named.emplace_back(name);
      }
      if (std::isupper(static_cast<unsigned char>(word[0])) && digits_in(word) == word.npos &&
          !words_.contains(word))
        words_.emplace(word);
      i = end;
    }
  }

  /// A number for the content of a file, without the order of its lines; `own`: digits that stand for itself.
  std::uint64_t number_of(const std::string& name, const std::string& own) {
    std::string_view text = texts_.at(name);
    std::uint64_t sum = 0;
    if (name.ends_with(".png")) {
      sum = Seed{}.child(text).bits();
    } else {
      for (bool first = true; !text.empty(); first = false) {
        std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end);
        if (line.starts_with("//")) {
          std::size_t head = first ? line.find("Render with") : line.npos;
          if (head == line.npos) continue;
          line.remove_prefix(head);
        }
        sum += Seed{}.child(unnamed(line, own)).bits();
      }
    }
    // What it is called counts without the digits of its content.
    std::string plain = name;
    if (std::size_t at = own.empty() ? plain.npos : plain.find(own); at != plain.npos)
      plain.erase(at, kDigits);
    return Seed{sum}.child(plain).bits();
  }

  /// A line with numbers of content in place of the digits of names.
  std::string unnamed(std::string_view line, const std::string& own) {
    std::string plain;
    for (std::size_t i = 0; i < line.size();) {
      if (!in_word(line[i])) {
        plain += line[i++];
        continue;
      }
      std::size_t end = word_end(line, i);
      std::string_view word = line.substr(i, end - i);
      i = end;
      if (std::size_t at = digits_in(word); at != word.npos) {
        std::string digits(word.substr(at, kDigits));
        plain += word.substr(0, at);
        plain += digits == own ? "own" : fmt::format("{:016x}", number_of_group(digits));
        plain += word.substr(at + kDigits);
      } else {
        plain += word;
      }
    }
    return plain;
  }

  /// A number for all files whose names have those digits.
  std::uint64_t number_of_group(const std::string& digits) {
    if (auto known = numbers_.find(digits); known != numbers_.end()) return known->second;
    numbers_[digits] = 0;  // while its own files are read
    std::uint64_t sum = 0;
    if (auto files = groups_.find(digits); files != groups_.end())
      for (const std::string& name : files->second) sum += number_of(name, digits);
    return numbers_[digits] = sum;
  }

  const fs::path& folder_;
  std::set<std::string, std::less<>> there_;                          // the names of the folder's files
  std::map<std::string, std::string, std::less<>> texts_;             // of the files that are named
  std::map<std::string, std::set<std::string, std::less<>>> groups_;  // of files, by their digits
  std::map<std::string, std::uint64_t> numbers_;                      // of these
  std::set<std::string, std::less<>> words_;
};

}  // namespace

Result<SceneContent> scene_content(const fs::path& folder, const std::vector<fs::path>& scenes) {
  return Contents(folder).read(scenes);
}

}  // namespace frond
