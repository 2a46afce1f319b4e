#include "scene/needs.h"

#include <algorithm>
#include <map>

#include "preset/json.h"
#include "preset/manual.h"
#include "scene/preset.h"

namespace frond {

namespace {

/// All properties by their paths.
const std::map<std::string, Topic>& topics_by_path() {
  static const std::map<std::string, Topic> all = [] {
    std::map<std::string, Topic> list;
    for (Topic& topic : topics_of(preset_schema())) list.emplace(topic.path, topic);
    return list;
  }();
  return all;
}

/// What stands in front of `end`, which is taken off the text with it.
std::string_view consume_until(std::string_view& text, std::string_view end) {
  std::size_t at = std::min(text.find(end), text.size());
  std::string_view taken = text.substr(0, at);
  text.remove_prefix(std::min(at + end.size(), text.size()));
  return taken;
}

/// A value as needs spell it.
std::string spelled(const Value& value) {
  if (value.is(Value::Type::text)) return value.text;
  if (value.is(Value::Type::boolean)) return value.boolean ? "true" : "false";
  return "";
}

bool is_met(const Need& need, const Value& object, const std::string& path) {
  const Value* beside = object.find(need.name);
  auto known = topics_by_path().find(path + "/" + std::string(need.name));
  if (!beside && known == topics_by_path().end()) return true;
  if (need.of == Need::Of::above_0)
    return beside ? beside->is(Value::Type::list) || beside->number > 0 : known->second.initial != "0";
  std::string value = beside ? spelled(*beside) : known->second.initial;
  std::erase(value, '"');
  if (need.of == Need::Of::other) return value != need.value;
  for (std::string_view any = need.value; !any.empty();)
    if (consume_until(any, "\" or \"") == value) return true;
  return false;
}

class NeedFinder {
 public:
  using Unmet = std::function<void(const Value&, const std::string&, std::string_view)>;
  explicit NeedFinder(const Unmet& unmet) : unmet_(unmet) {}

  /// Visits the members of an object, whose topics stand below `path`, or in part below `common`, and calls
  /// `unmet` for those whose needs are not met.
  void look(const Value& object, const std::string& path, const std::string& common,
            const std::string& pointer) const {
    for (const Member& member : object.members) {
      std::string below = path + "/" + member.name;
      auto topic = topics_by_path().find(below);
      if (topic == topics_by_path().end() && !common.empty())
        topic = topics_by_path().find(below = common + "/" + member.name);
      if (topic == topics_by_path().end()) continue;
      std::string at = pointer + "/" + member.name;
      std::optional<Need> need = need_of(topic->second.sentence);
      if (need && !is_met(*need, object, below.substr(0, below.rfind('/')))) {
        unmet_(member.value, at, need->words);
        continue;
      }
      look(member.value, below, "", at);
      for (std::size_t i = 0; i < member.value.items.size(); ++i)
        look(member.value.items[i], below, "", at + "/" + std::to_string(i));
    }
  }

 private:
  const Unmet& unmet_;
};

}  // namespace

std::optional<Need> need_of(std::string_view sentence) {
  std::size_t at = sentence.find("Needs ");
  if (at == sentence.npos) return std::nullopt;
  std::string_view rest = sentence.substr(at + 6);
  Need need;
  need.words = rest;
  if (rest.starts_with('"')) {
    rest.remove_prefix(1);
    need.name = consume_until(rest, "\": ");
    rest = consume_until(rest, ",");
    if (rest.starts_with('"')) rest = rest.substr(1, rest.rfind('"') - 1);
    need.value = rest;
    need.words = need.words.substr(0, need.words.find(','));
    return need;
  }
  if (rest.starts_with("a ")) rest.remove_prefix(2);
  need.name = consume_until(rest, " ");
  if (rest == "above 0") {
    need.of = Need::Of::above_0;
    return need;
  }
  if (!rest.starts_with("other than ")) return std::nullopt;
  need.of = Need::Of::other;
  need.value = rest.substr(11);
  return need;
}

void find_unmet(const Value& organism,
                const std::function<void(const Value&, const std::string&, std::string_view)>& unmet) {
  const Value* kind = organism.find("kind");
  if (!kind) return;
  NeedFinder(unmet).look(organism, kind->text, "organism", "");
}

}  // namespace frond
