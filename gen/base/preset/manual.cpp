#include "preset/manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "core/text.h"
#include "preset/json.h"
#include "preset/synonyms.h"

namespace frond {
namespace {

std::string text_of(const Value& schema, std::string_view name) {
  const Value* value = schema.find(name);
  return value ? value->text : std::string();
}

bool is_type(const Value& schema, std::string_view type) { return text_of(schema, "type") == type; }

/// The schema of a value, from that of the value or its keyframes, or else a name; null for other schemas.
const Value* key_of(const Value& schema) {
  const Value* any = schema.find("anyOf");
  if (!any || any->items.size() < 2 || any->items.size() > 3) return nullptr;
  const Value* items = any->items[1].find("items");
  const Value* pair = items ? items->find("items") : nullptr;
  return pair && pair->is(Value::Type::list) ? any->items.data() : nullptr;
}

/// The schema of an object, from that of the object or a bare value that stands for it; else the schema
/// itself.
const Value& object_of(const Value& schema) {
  if (const Value* any = schema.find("anyOf"))
    for (const Value& option : any->items)
      if (is_type(option, "object")) return option;
  return schema;
}

bool is_color(const Value& schema) {
  const Value* any = schema.find("anyOf");
  return any && any->items.front().find("pattern");
}

std::string range_of(const Value& schema) {
  if (const Value* key = key_of(schema)) return range_of(*key);
  const Value* least = schema.find("minimum");
  const Value* above = schema.find("exclusiveMinimum");
  const Value* most = schema.find("maximum");
  if (above) return "above " + serialize(*above) + (most ? " up to " + serialize(*most) : "");
  if (least && most) return serialize(*least) + " to " + serialize(*most);
  if (least) return serialize(*least) + " or more";
  if (most) return "at most " + serialize(*most);
  const Value* items = schema.find("items");
  return items && items->is(Value::Type::object) && is_type(schema, "array") && !items->find("properties")
             ? range_of(*items)
             : "";
}

std::string kind_of(const Value& schema);

std::string list_kind(const Value& schema) {
  const Value* items = schema.find("items");
  const Value *least = schema.find("minItems"), *most = schema.find("maxItems");
  bool fixed = least && most && least->number == most->number && least->number <= 4;
  if (fixed && items && (is_type(*items, "number") || is_type(*items, "integer"))) {
    if (least->number == 3) return "[x, y, z]";
    return "[a, b]";
  }
  std::string of = items ? kind_of(object_of(*items)) : "value";
  return "list of " + of + (of.ends_with(']') || of.ends_with('s') ? "" : "s");
}

std::string kind_of(const Value& schema) {
  if (const Value* key = key_of(schema))
    return kind_of(*key) +
           (schema.find("anyOf")->items.size() == 3 ? ", keyframes or text" : " or keyframes");
  if (is_color(schema)) return "colour";
  if (schema.find("enum")) return "name";
  const Value& whole = object_of(schema);
  std::string type = text_of(whole, "type");
  if (type == "array") return list_kind(whole);
  if (type == "boolean") return "true or false";
  if (type == "integer") return "whole number";
  if (type == "string") return "text";
  return type.empty() ? "value" : type;
}

/// Splits the unit off the end of a description: `How high it is (m)`.
std::string split_unit(std::string& text) {
  constexpr std::string_view kUnits[] = {"m",      "degrees", "s",     "1/s", "1/m2", "h",     "years",
                                         "pixels", "m2",      "bytes", "m/s", "Pa",   "kg/m2", "kg/m3"};
  std::size_t open = text.rfind(" (");
  if (open == text.npos || !text.ends_with(')')) return {};
  std::string unit = text.substr(open + 2, text.size() - open - 3);
  if (std::ranges::find(kUnits, unit) == std::end(kUnits) && !unit.starts_with("m, ")) return {};
  text.resize(open);
  return unit;
}

/// Splits what its names mean off the end of a description: `What it is. wild: as in a wood; tame: as in a
/// park`.
void split_choices(const Value& names, Topic& topic) {
  std::string& text = topic.sentence;
  std::size_t end = text.size(), first = text.size();
  for (std::size_t i = names.items.size(); i-- > 0;) {
    const std::string& name = names.items[i].text;
    std::string doc;
    for (std::string_view before : {". ", "; "}) {
      std::size_t at = text.rfind(fmt::format("{}{}: ", before, name), end);
      if (at == text.npos) continue;
      std::size_t from = at + before.size() + name.size() + 2;
      doc = text.substr(from, end - from);
      end = first = at;
      break;
    }
    topic.choices.insert(topic.choices.begin(), {name, doc});
  }
  text.resize(first);
}

void append_topics(std::vector<Topic>& topics, const std::string& above, const Value& object);

void append_topic(std::vector<Topic>& topics, const std::string& path, const Value& schema,
                  bool within = true) {
  Topic topic;
  topic.path = path;
  topic.sentence = text_of(schema, "description");
  topic.kind = kind_of(schema);
  topic.unit = split_unit(topic.sentence);
  if (const Value* names = schema.find("enum")) split_choices(*names, topic);
  topic.range = range_of(schema);
  if (const Value* initial = schema.find("default")) topic.initial = serialize(*initial);
  topics.push_back(std::move(topic));
  if (!within) return;
  const Value* items = schema.find("items");
  append_topics(topics, path + "/",
                object_of(items && items->is(Value::Type::object) ? object_of(*items) : schema));
}

void append_topics(std::vector<Topic>& topics, const std::string& above, const Value& object) {
  const Value* properties = object.find("properties");
  for (std::size_t i = 0; properties && i < properties->members.size(); ++i) {
    const Member& member = properties->members[i];
    if (member.value.is(Value::Type::object)) append_topic(topics, above + member.name, member.value);
  }
}

/// How well a topic answers a word, 0 not at all; `whole` becomes false where only a longer word does.
int rank_of(const Topic& topic, std::string_view word, bool& whole) {
  std::vector<std::string> steps = split(topic.path, '/');
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (singular(lower_case(steps[i])) == singular(word)) return i + 1 == steps.size() ? 100 : 60;
  std::string choices, path = lower_case(topic.path);
  std::ranges::replace(path, '_', ' ');
  for (const auto& [name, doc] : topic.choices) {
    if (lower_case(name) == word) return 50;
    choices += " " + lower_case(name + " " + doc);
  }
  constexpr int kOfPath[] = {0, 4, 30, 40}, kOfSentence[] = {0, 2, 15, 20}, kOfChoices[] = {0, 1, 8, 10};
  int in_path = says(path, word), in_sentence = says(lower_case(topic.sentence), word),
      in_choices = says(choices, word);
  whole = whole && std::max({in_path, in_sentence, in_choices}) > 1;
  return std::max({kOfPath[in_path], kOfSentence[in_sentence], kOfChoices[in_choices]});
}

/// Topics that say all words, the best first; those that only say longer words with the same beginning count
/// where there are no others.
std::vector<Topic> ranked(const std::vector<Topic>& topics, std::string_view asked) {
  struct Ranked {
    const Topic* topic;
    int rank;
    bool whole;
  };
  std::vector<Ranked> found;
  for (const Topic& topic : topics) {
    Ranked one{&topic, 0, true};
    bool all = true;
    for (const std::string& word : split(asked, ' ')) {
      if (word.empty()) continue;
      int rank = rank_of(topic, word, one.whole);
      all = all && rank > 0;
      one.rank += rank;
    }
    if (all && one.rank > 0) found.push_back(one);
  }
  if (std::ranges::any_of(found, &Ranked::whole))
    std::erase_if(found, [](const Ranked& one) { return !one.whole; });
  std::ranges::stable_sort(found, std::greater<>(), &Ranked::rank);
  std::vector<Topic> list;
  for (const Ranked& one : found) list.push_back(*one.topic);
  return list;
}

/// Joins those that say the same of several kinds.
std::vector<Topic> joined(const std::vector<Topic>& topics) {
  std::vector<Topic> list;
  std::vector<std::string> rest;  // of each, its path below its kind
  for (const Topic& topic : topics) {
    std::size_t slash = std::min(topic.path.find('/'), topic.path.size());
    std::string below = topic.path.substr(slash);
    std::size_t same = 0;
    while (same < list.size() && !(rest[same] == below && !below.empty() &&
                                   list[same].sentence == topic.sentence && list[same].range == topic.range))
      ++same;
    if (same == list.size()) {
      list.push_back(topic);
      rest.push_back(below);
      continue;
    }
    Topic& known = list[same];
    std::string kind = topic.path.substr(0, slash);
    known.path.insert(known.path.size() - below.size(), ", " + kind);
    if (known.initial != topic.initial) known.initial.clear();
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::size_t at = list[i].path.size() - rest[i].size();
    if (list[i].path.find(", ") < at) list[i].path.replace(at, 1, ": ");
  }
  return list;
}

}  // namespace

std::vector<Topic> topics_of(const Value& schema) {
  std::vector<Topic> topics;
  const Value& properties = *schema.find("properties");
  for (const Member& member : properties.members) {
    bool elements = member.name == "organisms" || member.name == "defaults";
    if (member.name != "$schema") append_topic(topics, member.name, member.value, !elements);
  }
  const Value& element = *properties.find("organisms")->find("items");
  append_topics(topics, "organism/", element);
  for (const Value& kind : element.find("allOf")->items) {
    const std::string& name = kind.find("if")->find("properties")->find("kind")->find("const")->text;
    append_topics(topics, name + "/", *kind.find("then"));
  }
  return topics;
}

std::vector<Topic> topics_about(const std::vector<Topic>& topics, std::string_view asked) {
  std::string low = lower_case(asked);
  while (low.ends_with('/')) low.pop_back();
  std::vector<Topic> found;
  auto add_found = [&](const auto& wanted) {
    for (const Topic& topic : topics)
      if (wanted(topic)) found.push_back(topic);
    return !found.empty();
  };
  if (low.empty()) return found;
  if (add_found([&](const Topic& t) { return t.path == low || t.path.starts_with(low + "/"); }))
    return joined(found);
  // What all kinds have may be asked of one of them.
  std::size_t slash = low.find('/');
  if (slash != low.npos) {
    std::string common = "organism" + low.substr(slash);
    bool kind = std::ranges::any_of(
        topics, [&](const Topic& t) { return t.path.starts_with(low.substr(0, slash + 1)); });
    if (kind &&
        add_found([&](const Topic& t) { return t.path == common || t.path.starts_with(common + "/"); }))
      return found;
    std::string inner = "/" + low;
    if (add_found([&](const Topic& t) {
          std::string path = t.path + "/";
          return path.find(inner + "/") != path.npos;
        }))
      return joined(found);
  }
  std::ranges::replace(low, '/', ' ');
  return joined(ranked(topics, low));
}

std::string nearest_topic(const std::vector<Topic>& topics, std::string_view asked) {
  std::string low = lower_case(asked), meant;
  while (low.ends_with('/')) low.pop_back();
  std::vector<std::string> paths, names;
  for (const Topic& topic : topics) {
    paths.push_back(topic.path);
    std::ranges::move(split(topic.path, '/'), std::back_inserter(names));
  }
  if (std::size_t slash = low.find('/'); slash != low.npos) {
    // What all kinds have may be asked of one of them.
    std::string kind = low.substr(0, slash);
    bool known = std::ranges::find(names, kind) != names.end();
    for (const Topic& topic : topics)
      if (known && topic.path.starts_with("organism/")) paths.push_back(kind + topic.path.substr(8));
    return std::string(nearest_name(low, paths));
  }
  for (std::string word : split(low, ' ')) {
    if (topics_about(topics, word).empty()) {
      // A slip of the keys, and not a word of another sense that has about the same letters.
      std::string near(nearest_name(word, names));
      std::size_t most = word.size() < 6 ? 1 : 2;
      word = !near.empty() && near[0] == word[0] && edit_distance(near, word) <= most ? near : "";
    }
    if (word.empty()) return {};
    meant += (meant.empty() ? "" : " ") + word;
  }
  return topics_about(topics, meant).empty() ? "" : meant;
}

std::string topic_text(const Topic& topic) {
  std::string text = topic.path + "  (" + topic.kind;
  if (!topic.range.empty()) text += ", " + topic.range;
  if (!topic.unit.empty()) text += topic.range.empty() ? ", " + topic.unit : " " + topic.unit;
  if (!topic.initial.empty()) text += "; default " + topic.initial;
  text += ")\n    " + topic.sentence + ".\n";
  for (const auto& [name, doc] : topic.choices) text += fmt::format("      {:12} {}\n", name, doc);
  return text;
}

}  // namespace frond
