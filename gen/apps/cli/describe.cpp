#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <vector>

#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "core/printable.h"
#include "core/text.h"
#include "organisms/kinds.h"
#include "preset/json.h"
#include "preset/manual.h"
#include "preset/synonyms.h"
#include "scene/describe.h"
#include "settings/settings.h"

// The words of the schema in the terminal: describe.

namespace frond {

namespace fs = std::filesystem;

namespace {

Value json_of(const Topic& topic) {
  Value row = make_object();
  auto say = [&](std::string_view name, const std::string& text) {
    if (!text.empty()) row.set(name, make_text(text));
  };
  say("path", topic.path);
  say("sentence", topic.sentence);
  say("kind", topic.kind);
  say("range", topic.range);
  say("unit", topic.unit);
  say("default", topic.initial);
  Value choices = make_object();
  for (const auto& [name, doc] : topic.choices) choices.set(name, make_text(doc));
  if (!choices.members.empty()) row.set("choices", std::move(choices));
  return row;
}

/// What there is to ask for.
std::string contents(const std::vector<Topic>& topics) {
  std::string text = "Kinds of organisms\n";
  for (const auto& row : organism_kinds()) text += fmt::format("  {:12} {}\n", row.name, row.doc);
  text += "Settings\n";
  for (const SettingRow& row : settings())
    text += fmt::format("  {:12} {}; its properties are {}\n", row.name, row.doc,
                        row.block == row.name ? "below" : row.block);
  text += "What all organisms have\n";
  for (const Topic& topic : topics)
    if (topic.path.starts_with("organism/") && std::ranges::count(topic.path, '/') == 1)
      text += fmt::format("  {:20} {}\n", topic.path, topic.sentence);
  text += "The preset itself\n";
  for (const Topic& topic : topics)
    if (topic.path.find('/') == topic.path.npos)
      text += fmt::format("  {:12} {}\n", topic.path, topic.sentence);
  return text +
         "\nThen, for instance:\n"
         "  frond describe tree            all properties of a kind\n"
         "  frond describe tree/habit      those of one part of it\n"
         "  frond describe leaf size       what has to do with these words: properties, presets, pages\n";
}

/// Where something is found besides properties.
struct Finding {
  std::string where;  ///< a path seen from the folder of Frond
  std::string says;   ///< the preset's title, or the words that say it
  int rank = 0;
};

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
  std::size_t at = std::min(lower_case(text).find(singular(word)), text.size());
  std::size_t from = at > kWidth / 2 ? text.find(' ', at - kWidth / 2) : 0;
  if (from == text.npos || from >= at) from = 0;
  std::size_t to = text.size() - from > kWidth ? text.rfind(' ', from + kWidth) : text.size();
  if (to == text.npos || to <= from) to = text.size();
  std::string part = text.substr(from, to - from);
  part.erase(0, part.find_first_not_of(" |-"));
  return (from > 0 ? "... " : "") + part + (to < text.size() ? " ..." : "");
}

/// The presets and grammars of a folder of Frond that say all words by their names, titles, organisms or
/// comments, the best first.
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
    one.rank = rank_of({{lower_case(names), 50},
                        {lower_case(one.says), 40},
                        {lower_case(names_of(document->root)), 20},
                        {lower_case(comments_of(*text)), 5}},
                       words);
    if (one.rank > 0) found.push_back(std::move(one));
  }
  sort_best_first(found);
  return found;
}

/// The pages of docs/ that say all words in a heading or in a line, the best first; one finding a page.
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
      int rank = !words_only ? 0 : rank_of({{lower_case(line), heading ? 40 : 10}}, words);
      if (rank > best.rank) best.rank = rank, best.says = shown(line, words[0]);
    }
    if (best.rank > 0) found.push_back(std::move(best));
  }
  sort_best_first(found);
  return found;
}

constexpr std::size_t kWhole = 12;  // properties that are told as a whole
constexpr std::size_t kNamed = 40;  // those that are only named
constexpr std::size_t kOthers = 6;  // presets, and pages

/// The words that are asked for, in small letters.
std::vector<std::string> asked_words(std::string asked) {
  std::ranges::replace(asked, '/', ' ');
  std::vector<std::string> words = split(lower_case(asked), ' ');
  std::erase(words, "");
  return words;
}

/// Properties: the best as a whole, others by their names. Those of a path that was asked for all as a whole.
std::string properties_text(const std::vector<Topic>& found, bool of_path) {
  std::string text, more;
  std::size_t named = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (of_path || i < kWhole)
      text += topic_text(found[i]);
    else if (++named <= kNamed)
      more += (more.empty() ? "" : "; ") + found[i].path;
  }
  if (named > kNamed) more += fmt::format("; and {} more", named - kNamed);
  return more.empty() ? text : text + "Also: " + more + "\n";
}

std::string others_text(const char* heading, const std::vector<Finding>& found) {
  if (found.empty()) return {};
  std::string text = std::string(heading) + "\n";
  for (std::size_t i = 0; i < std::min(found.size(), kOthers); ++i)
    text += fmt::format("  {:34} {}\n", printable(found[i].where), printable(found[i].says));
  if (found.size() > kOthers) text += fmt::format("  and {} more\n", found.size() - kOthers);
  return text;
}

/// Presets and pages of the docs about some words.
std::string beside(const std::vector<std::string>& words) {
  Result<fs::path> root = home();
  if (!root || words.empty()) return {};
  return others_text("Presets", presets_about(*root, words)) +
         others_text("Pages", pages_about(*root, words));
}

/// What there is about words that mean about the same as those that are asked for, of which there is nothing.
std::string about_the_like(const std::vector<Topic>& topics, const std::vector<std::string>& words) {
  std::string text, names;
  for (const std::string& word : words)
    for (const std::string& like : words_like(word)) {
      std::vector<Topic> found = topics_about(topics, like);
      std::string own;
      for (std::size_t i = 0; i < std::min<std::size_t>(found.size(), 3); ++i) own += topic_text(found[i]);
      if (Result<fs::path> root = home()) own += others_text("Presets", presets_about(*root, {like}));
      if (own.empty()) continue;
      names += (names.empty() ? "" : ", ") + like;
      text += fmt::format("\n{}\n{}", like, own);
    }
  return names.empty() ? "" : fmt::format("What comes near in sense: {}\n{}", names, text);
}

}  // namespace

void describe_properties(const DescribeArguments& arguments) {
  std::vector<Topic> topics = topics_of(preset_schema());
  std::string asked = fmt::format("{}", fmt::join(arguments.words, " "));
  std::vector<Topic> found = asked.empty() ? topics : topics_about(topics, asked);
  if (arguments.json) {
    Value all = make_list();
    for (const Topic& topic : found) all.items.push_back(json_of(topic));
    put(serialize_pretty(all) + "\n");
    return;
  }
  if (asked.empty()) {
    put(contents(topics));
    return;
  }
  std::vector<std::string> list = asked_words(asked);
  bool of_path = std::ranges::any_of(
      topics, [&](const Topic& topic) { return topic.path == asked || topic.path.starts_with(asked + "/"); });
  bool kind = std::ranges::any_of(organism_kinds(), [&](const auto& row) { return row.name == asked; });
  // A property's own path is a whole answer; a word, or a kind, is one of many things, too.
  std::string others = asked.find('/') == asked.npos ? beside(list) : "";
  std::string like = found.empty() ? about_the_like(topics, list) : "";
  if (found.empty() && others.empty() && like.empty()) {
    std::string near = nearest_topic(topics, asked);
    tell(fmt::format("{}: no property has this name, and none has these words; {}", printable(asked),
                     near.empty() ? "see `frond describe`" : fmt::format("did you mean \"{}\"?", near)));
    throw CommandEnd{kWrongInput};
  }
  if (found.empty()) put(fmt::format("{}: no property has this name\n", printable(asked)));
  put(properties_text(found, of_path || asked.find('/') != asked.npos));
  // What a kind shares with all others is only named.
  if (kind) {
    std::string shared;
    for (const Topic& topic : topics)
      if (topic.path.starts_with("organism/") && std::ranges::count(topic.path, '/') == 1)
        shared += (shared.empty() ? "" : ", ") + topic.path.substr(9);
    put(fmt::format("All kinds have {}, too: frond describe organism\n", shared));
  }
  put(others + like);
}

}  // namespace frond
