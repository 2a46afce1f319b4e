#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/search.h"
#include "cli/streams.h"
#include "core/printable.h"
#include "organisms/kinds.h"
#include "preset/json.h"
#include "preset/manual.h"
#include "preset/synonyms.h"
#include "scene/describe.h"
#include "settings/settings.h"

// The words of the schema in the terminal: describe.

namespace frond {
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

constexpr std::size_t kWhole = 12;  // properties that are told as a whole
constexpr std::size_t kNamed = 40;  // those that are only named
constexpr std::size_t kOthers = 6;  // presets, and pages

/// The words that are asked for, in small letters.
std::vector<std::string> asked_words(const std::string& asked) {
  std::vector<std::string> words;
  std::string word;
  for (char c : asked + ' ') {
    if (c != ' ' && c != '/') {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      continue;
    }
    if (!word.empty()) words.push_back(std::move(word));
    word.clear();
  }
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
  Result<std::filesystem::path> root = home();
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
      if (Result<std::filesystem::path> root = home())
        own += others_text("Presets", presets_about(*root, {like}));
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
