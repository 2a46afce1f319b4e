#include "scene/upgrade.h"

#include <fmt/format.h>

#include "core/vec.h"
#include "preset/json.h"
#include "preset/text_edits.h"
#include "scene/unused_properties.h"

namespace frond {
namespace {

/// What is rewritten of one preset. Each rule looks at the text as it was read, and no two change the same
/// part.
class Upgrader {
 public:
  Upgrader(std::string_view text, const Value& root, const std::function<bool(const std::string&)>& is_there)
      : root_(root), edits_(std::string(text)), is_there_(is_there) {}

  Upgrade upgrade() && {
    if (const Value* meadow = at(root_, "scene", "meadow")) painted_hills(*meadow);
    if (const Value* events = at(root_, "stand", "events")) stand_events(*events);
    if (const Value* base = root_.find("base")) moved_file(*base, "/base");
    if (const Value* defaults = root_.find("defaults")) organism(*defaults, "/defaults");
    if (const Value* organisms = root_.find("organisms"))
      for (std::size_t i = 0; i < organisms->items.size(); ++i)
        organism(organisms->items[i], fmt::format("/organisms/{}", i));
    return {edits_.text(), std::move(changes_)};
  }

 private:
  static const Value* at(const Value& root, std::string_view first, std::string_view second) {
    const Value* part = root.find(first);
    return part ? part->find(second) : nullptr;
  }

  void note(const Value& value, const std::string& pointer, std::string what) {
    changes_.push_back({value.origin.text() + ": " + pointer, std::move(what)});
  }

  void organism(const Value& entry, const std::string& pointer) {
    // Wavelengths of a pattern; waves of the water are an object.
    const Value* wave = entry.find("wave");
    if (wave && wave->is(Value::Type::number)) {
      edits_.rename(pointer + "/wave", "valley");
      note(*wave, pointer + "/wave", "is called valley");
    }
    const Value* species = entry.find("species");
    if (species && species->is(Value::Type::text) && species->text.ends_with(".xml")) {
      edits_.rename(pointer + "/species", "arbaro");
      note(*species, pointer + "/species", "is called arbaro, where it is a file of Arbaro");
    } else if (species) {
      moved_file(*species, pointer + "/species");
    }
    const Value* strength = at(entry, "food", "strength");
    if (!root_.find("version") && strength && is_radians(*strength)) {
      std::string turned = fmt::format("{:.6g}", degrees(strength->number));
      edits_.replace(pointer + "/food/strength", turned);
      note(*strength, pointer + "/food/strength",
           fmt::format("is in degrees: {} for {:g} radians", turned, strength->number));
    }
  }

  /// What angles in radians look like that are not so small that they might be degrees as well.
  static bool is_radians(const Value& value) {
    return value.is(Value::Type::number) && value.number <= kRadians && degrees(value.number) > kRadians;
  }

  /// Presets of Frond's own that have another name now.
  void moved_file(const Value& value, const std::string& pointer) {
    constexpr std::string_view kWas = "species/corals/bush.json", kIs = "species/corals/bird_nest.json";
    if (!value.is(Value::Type::text) || !value.text.ends_with(kWas) || is_there_(value.text)) return;
    std::string name = value.text.substr(0, value.text.size() - kWas.size()).append(kIs);
    edits_.replace(pointer, serialize(make_text(name)));
    note(value, pointer, fmt::format("is called \"{}\"", name));
  }

  /// Hills were a band behind the meadow, as high as a factor told; now they are land.
  void painted_hills(const Value& meadow) {
    constexpr double kRelief = 70;
    const std::string pointer = "/scene/meadow";
    if (const Value* distance = meadow.find("hills_distance")) {
      edits_.remove(pointer + "/hills_distance");
      note(*distance, pointer + "/hills_distance", "is gone: land begins where the meadow ends");
    }
    const Value* hills = meadow.find("hills");
    if (!hills) return;
    edits_.remove(pointer + "/hills");
    if (root_.find("scene")->find("far") || !hills->is(Value::Type::number) || hills->number == 1) {
      note(*hills, pointer + "/hills", "is gone: far land is told by /scene/far");
      return;
    }
    std::string far = fmt::format("{{\"relief\": {:.4g}{}}}", kRelief * hills->number,
                                  hills->number == 0 ? ", \"woods\": 0" : "");
    edits_.insert_after(pointer, "far", far);
    note(*hills, pointer + "/hills", fmt::format("is told by /scene/far: {}", far));
  }

  /// The name of the organism that a stand draws trees of a species as; empty: none.
  std::string drawn_as(const std::string& name) const {
    if (const Value* list = at(root_, "stand", "species"))
      for (const Value& species : list->items) {
        const Value *own = species.find("name"), *organism = species.find("organism");
        if (own && own->text == name && organism) return organism->text;
      }
    return "";
  }

  /// Events of a stand are those of the whole preset, and a felling is an object.
  void stand_events(const Value& events) {
    const std::string pointer = "/stand/events";
    if (root_.find("events") || !events.is(Value::Type::list)) return;
    for (std::size_t i = 0; i < events.items.size(); ++i) {
      const Value *cut = events.items[i].find("cut"), *share = events.items[i].find("share");
      std::string place = fmt::format("{}/{}", pointer, i);
      if (cut && cut->is(Value::Type::text)) {
        constexpr double kUsualShare = 0.5;
        std::string entry = drawn_as(cut->text);
        // An organism of this name there is not, which is said when the preset is read.
        if (entry.empty()) entry = cut->text;
        edits_.replace(place + "/cut",
                       fmt::format("{{\"entry\": {}, \"share\": {}}}", serialize(make_text(entry)),
                                   serialize(make_number(share ? share->number : kUsualShare))));
        note(*cut, place + "/cut", "is an object, which names an organism and has the share");
      }
      if (share) edits_.remove(place + "/share");
    }
    std::optional<std::string> list = edits_.written(pointer);
    edits_.remove(pointer);
    if (list) edits_.insert_after("/stand", "events", *list);
    note(events, pointer, "is at /events");
  }

  const Value& root_;
  TextEdits edits_;
  const std::function<bool(const std::string&)>& is_there_;
  Errors changes_;
};

}  // namespace

Upgrade upgrade_preset(std::string_view text, const std::string& file_name,
                       const std::function<bool(const std::string& name)>& is_there) {
  Result<Document> document = parse_json(text, file_name);
  return document ? upgrade_preset(text, document->root, is_there) : Upgrade{std::string(text), {}};
}

Upgrade upgrade_preset(std::string_view text, const Value& root,
                       const std::function<bool(const std::string& name)>& is_there) {
  if (!root.is(Value::Type::object)) return {std::string(text), {}};
  return Upgrader(text, root, is_there).upgrade();
}

}  // namespace frond
