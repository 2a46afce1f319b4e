#include "cli/search.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <functional>

#include "core/files.h"
#include "core/text.h"
#include "preset/json.h"
#include "preset/synonyms.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

std::string small(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Parts of a thing, from that which tells most of it on.
struct Part {
  std::string text;
  int weight;
};

/// The sum over the words of what the best part says of each; 0 where one is said by none. Longer words with
/// the same beginning do not count.
int rank_of(const std::vector<Part>& parts, const std::vector<std::string>& words) {
  int sum = 0;
  for (const std::string& word : words) {
    int best = 0;
    for (const Part& part : parts)
      if (int how = says(part.text, word); how > 1) best = std::max(best, part.weight * (how - 1));
    if (best == 0) return 0;
    sum += best;
  }
  return sum;
}

void sort_best_first(std::vector<Finding>& found) {
  std::ranges::stable_sort(found, std::greater<>(), &Finding::rank);
}

/// The comments of a preset's text.
std::string comments_of(const std::string& text) {
  std::string all;
  for (const std::string& line : split(text, '\n'))
    if (std::size_t at = line.find("//"); at != line.npos) all += " " + line.substr(at + 2);
  return all;
}

std::string names_of(const Value& root) {
  std::string names;
  if (const Value* list = root.find("organisms"))
    for (const Value& organism : list->items)
      for (const char* name : {"name", "kind", "species"})
        if (const Value* said = organism.find(name)) names += " " + said->text;
  if (const Value* taxon = root.find("taxon")) {
    if (const Value* latin = taxon->find("latin")) names += " " + latin->text;
    if (const Value* list = taxon->find("names"))
      for (const Value& name : list->items) names += " " + name.text;
  }
  return names;
}

/// A line of a page without its marks, as much of it as a line of a terminal holds, round the first word.
std::string shown(const std::string& line, const std::string& word) {
  constexpr std::size_t kWidth = 100;
  std::string text;
  for (char c : line)
    if (c != '`' && c != '*' && c != '#') text += c;
  std::size_t at = std::min(small(text).find(singular(word)), text.size());
  std::size_t from = at > kWidth / 2 ? text.find(' ', at - kWidth / 2) : 0;
  if (from == text.npos || from >= at) from = 0;
  std::size_t to = text.size() - from > kWidth ? text.rfind(' ', from + kWidth) : text.size();
  if (to == text.npos || to <= from) to = text.size();
  std::string part = text.substr(from, to - from);
  part.erase(0, part.find_first_not_of(" |-"));
  return (from > 0 ? "... " : "") + part + (to < text.size() ? " ..." : "");
}

}  // namespace

std::vector<Finding> presets_about(const fs::path& home, const std::vector<std::string>& words) {
  std::vector<Finding> found;
  for (const fs::path& file : files_below(home / "presets")) {
    if (file.extension() != ".json") continue;
    Result<std::string> text = read_file(file);
    Result<Document> document = text ? parse_json(*text, file.string()) : text.errors();
    if (!document) continue;
    const Value* title = document->root.find("title");
    std::string path = file.lexically_relative(home).string(), names = path.substr(path.find('/'));
    std::ranges::replace(names, '_', ' ');
    Finding one{path, title ? title->text : "", 0};
    one.rank = rank_of({{small(names), 50},
                        {small(one.says), 40},
                        {small(names_of(document->root)), 20},
                        {small(comments_of(*text)), 5}},
                       words);
    if (one.rank > 0) found.push_back(std::move(one));
  }
  sort_best_first(found);
  return found;
}

std::vector<Finding> pages_about(const fs::path& home, const std::vector<std::string>& words) {
  std::vector<Finding> found;
  for (const fs::path& file : files_in(home / "docs")) {
    // The gallery lists presets, which are found by themselves.
    bool page = file.extension() == ".md" && file.stem() != "gallery";
    Result<std::string> text = page ? read_file(file) : Error{};
    if (!text) continue;
    Finding best{file.lexically_relative(home).string(), "", 0};
    for (const std::string& line : split(*text, '\n')) {
      bool heading = line.starts_with('#'), words_only = !line.empty() && !std::strchr("!<|", line[0]);
      int rank = !words_only ? 0 : rank_of({{small(line), heading ? 40 : 10}}, words);
      if (rank > best.rank) best.rank = rank, best.says = shown(line, words[0]);
    }
    if (best.rank > 0) found.push_back(std::move(best));
  }
  sort_best_first(found);
  return found;
}

}  // namespace frond
