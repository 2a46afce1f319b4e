#include "scene/unused_properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/function_ref.h"
#include "preset/fault.h"
#include "preset/manual.h"
#include "scene/describe.h"
#include "settings/settings.h"

namespace frond {

namespace {

/// What of `place` sown copies and ivy pass over.
constexpr std::string_view kScatter[] = {"center", "inner", "radius", "spacing", "rock"};
constexpr std::string_view kStance[] = {"size_variation", "turn", "turn_variation", "each", "lean"};

/// Whether a setting reads a property below the scene, by itself or as a part of its block.
bool reads(const SettingRow& setting, std::string_view pointer) {
  return std::ranges::any_of(setting.answers.reads, [&](std::string_view own) {
    return pointer == own || (pointer.starts_with(own) && pointer[own.size()] == '/');
  });
}

/// Whether it reads something of a block.
bool reads_some(const SettingRow& setting, std::string_view block) {
  return std::ranges::any_of(setting.answers.reads, [&](std::string_view own) {
    return own.starts_with(block) && (own.size() == block.size() || own[block.size()] == '/');
  });
}

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

using Unmet = FunctionRef<void(const Value&, const std::string&, std::string_view)>;

/// Visits the members of an object, whose topics stand below `path`, or in part below `common`, and calls
/// `unmet` for those that do nothing, for want of what their sentence needs: the value, the pointer to it,
/// and the words of the need.
void find_unmet(const Value& object, const std::string& path, const std::string& common,
                const std::string& pointer, Unmet unmet) {
  for (const Member& member : object.members) {
    std::string below = path + "/" + member.name;
    auto topic = topics_by_path().find(below);
    if (topic == topics_by_path().end() && !common.empty())
      topic = topics_by_path().find(below = common + "/" + member.name);
    if (topic == topics_by_path().end()) continue;
    std::string at = pointer + "/" + member.name;
    std::optional<Need> need = need_of(topic->second.sentence);
    if (need && !is_met(*need, object, below.substr(0, below.rfind('/')))) {
      unmet(member.value, at, need->words);
      continue;
    }
    find_unmet(member.value, below, "", at, unmet);
    for (std::size_t i = 0; i < member.value.items.size(); ++i)
      find_unmet(member.value.items[i], below, "", at + "/" + std::to_string(i), unmet);
  }
}

class Finder {
 public:
  Finder(const Preset& preset, const std::string& file_name) : preset_(preset), file_name_(file_name) {}

  Errors find() {
    const Value* scene = preset_.written->find("scene");
    const Value* setting = scene ? scene->find("setting") : nullptr;
    bool set = setting && setting->origin.line == 0;
    for (const SettingRow& row : settings()) note_block(row.block, set);
    for (std::string_view block : {"floor", "snow", "rain", "air", "year"}) note_block(block, set);
    const Value* events = preset_.written->find("events");
    for (std::size_t i = 0; events && !preset_.reef && i < events->items.size(); ++i)
      if (const Value* heat = events->items[i].find("heat"))
        note(*heat, fmt::format("/events/{}/heat", i), "it is for a preset with a reef");
    const Value* organisms = preset_.written->find("organisms");
    for (std::size_t i = 0; i < preset_.organisms.size(); ++i)
      note_organism(preset_.organisms[i], organisms->items[i], fmt::format("/organisms/{}", i));
    return notes_.errors();
  }

 private:
  static const Value* at(const Value& root, std::string_view pointer) {
    const Value* here = &root;
    while (here && !pointer.empty()) {
      std::string_view step = pointer.substr(1, pointer.find('/', 1) - 1);
      here = here->find(step);
      pointer.remove_prefix(step.size() + 1);
    }
    return here;
  }

  /// Whether it stands in the preset's own file or comes from the command line.
  bool own(const Value& value) const {
    const Origin& origin = value.origin;
    return !value.inherited && origin.source && (origin.line == 0 || *origin.source == file_name_);
  }

  void note(const Value& value, const std::string& pointer, std::string_view why) {
    if (own(value)) notes_.add({value.origin, pointer, fmt::format("does nothing here: {}", why)});
  }

  /// A block of parameters of the scene, or what of it the setting does not heed. Where the setting comes
  /// from the command line (`set`), what the file has for its own setting is left out.
  void note_block(std::string_view name, bool set) {
    std::string block = fmt::format("/{}", name);
    const Value* value = at(*preset_.written, "/scene" + block);
    if (!value) return;
    auto note_unheeded = [&](const Value& what, const std::string& pointer, auto heed) {
      if (set && what.origin.line != 0) return;
      std::string names;
      for (const SettingRow& row : settings())
        if (heed(row, pointer)) names += fmt::format("{}{}", names.empty() ? "" : ", ", row.name);
      note(what, "/scene" + pointer,
           fmt::format("the setting is {}; it is for {}", settings()[preset_.setup.setting].name, names));
    };
    const SettingRow& setting = settings()[preset_.setup.setting];
    if (!reads_some(setting, block)) return note_unheeded(*value, block, reads_some);
    for (const Member& member : value->members)
      if (std::string pointer = block + "/" + member.name; !reads(setting, pointer))
        note_unheeded(member.value, pointer, reads);
  }

  void note_organism(const Organism& organism, const Value& written, const std::string& pointer) {
    auto note_place = [&](std::string_view name, std::string_view why) {
      if (const Value* value = at(written, fmt::format("/place/{}", name)))
        note(*value, fmt::format("{}/place/{}", pointer, name), why);
    };
    bool ivy = organism.grower->traits().creeps();
    if (ivy || organism.sown)
      for (std::string_view name : kScatter)
        note_place(name, ivy ? "ivy roots at place.at, or anywhere on its host"
                             : "sown.where says where copies stand");
    if (ivy)
      for (std::string_view name : kStance) note_place(name, "ivy takes the shape of its host");
    if (!ivy && !organism.sown && organism.place.rock > 0 && !rocks_)
      note_place("rock", "rocks lie under water only");
    bool settles = organism.grower->traits().stands_on_bodies();
    if (!organism.sown && !settles)
      note_place("on", "only corals and their like, and what is sown, stand on bodies");
    if (organism.sown || !settles)
      note_place("upright", organism.sown ? "sown.upright says how copies stand"
                                          : "only corals and their like stand on bodies");
    if (organism.sown && !organism.place.on.empty())
      note_place("at", "copies on bodies find their own places");
    note_body(organism, written, pointer);
    bool drawn = organism.grower->traits().branches && !organism.sown;
    auto note_unmet = [&](const Value& value, const std::string& at, std::string_view need) {
      if (!drawn && at.starts_with("/body/")) return;  // all of it does nothing
      note(value, pointer + at, fmt::format("it needs {}", need));
    };
    if (const Value* kind = written.find("kind")) find_unmet(written, kind->text, "organism", "", note_unmet);
    note_motion(written, pointer, "wave", "amplitude");
    if (!at(written, "/food/stretch")) note_motion(written, pointer, "food", "strength");
    const Value* strength = at(written, "/food/strength");
    if (strength && strength->number > 0 && strength->number <= kRadians)
      notes_.add({strength->origin, pointer + "/food/strength",
                  fmt::format("is an angle in degrees; {:g} radians would be {:.6g}", strength->number,
                              degrees(strength->number))});
  }

  /// How branches are drawn, where there are none.
  void note_body(const Organism& organism, const Value& written, const std::string& pointer) {
    const Value* body = written.find("body");
    if (!body) return;
    if (!organism.grower->traits().branches || organism.sown)
      note(*body, pointer + "/body",
           organism.sown ? "copies that are sown are drawn branch by branch"
                         : "this kind has no branches, which it is for");
  }

  /// What moves only by a number that nobody gave.
  void note_motion(const Value& written, const std::string& pointer, std::string_view motion,
                   std::string_view strength) {
    const Value* value = written.find(motion);
    if (!value || value->members.empty() || value->find(strength)) return;
    note(*value, fmt::format("{}/{}", pointer, motion),
         fmt::format("its {} is not given and so is 0", strength));
  }

  const Preset& preset_;
  const std::string& file_name_;
  bool rocks_ = settings()[preset_.setup.setting].answers.extent(preset_.setup).rocks;
  Faults notes_;  // what the defaults say is said once
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

Errors unused_properties(const Preset& preset, const std::string& file_name) {
  return Finder(preset, file_name).find();
}

}  // namespace frond
