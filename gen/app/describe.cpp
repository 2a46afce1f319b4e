#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/commands.h"
#include "app/messages.h"
#include "app/streams.h"
#include "core/printable.h"
#include "preset/json.h"
#include "preset/manual.h"
#include "scene/describe.h"

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
         "  frond describe leaf size       what has to do with these words\n";
}

}  // namespace

int describe_properties(const std::vector<std::string>& words, bool json) {
  Result<Document> schema = parse_json(preset_schema(), "schema");
  if (!schema) return fail(schema.errors(), kCouldNot);
  std::vector<Topic> topics = topics_of(schema->root);
  std::string asked = fmt::format("{}", fmt::join(words, " "));
  std::vector<Topic> found = asked.empty() ? topics : topics_about(topics, asked);
  if (json) {
    Value all = make_list();
    for (const Topic& topic : found) all.items.push_back(json_of(topic));
    put(serialize_pretty(all) + "\n");
    return kDone;
  }
  if (asked.empty()) {
    put(contents(topics));
    return kDone;
  }
  if (found.empty()) {
    std::string near = nearest_topic(topics, asked);
    tell(fmt::format("{}: no property has this name, and none has these words; {}", printable(asked),
                     near.empty() ? "see `frond describe`" : fmt::format("did you mean \"{}\"?", near)));
    return kWrongInput;
  }
  for (const Topic& topic : found) put(topic_text(topic));
  // Of a kind, what it shares with all others is only named.
  if (std::ranges::any_of(organism_kinds(), [&](const auto& row) { return row.name == asked; })) {
    std::string shared;
    for (const Topic& topic : topics)
      if (topic.path.starts_with("organism/") && std::ranges::count(topic.path, '/') == 1)
        shared += (shared.empty() ? "" : ", ") + topic.path.substr(9);
    put(fmt::format("All kinds have {}, too: frond describe organism\n", shared));
  }
  return kDone;
}

}  // namespace frond
