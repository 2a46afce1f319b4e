#include "scene/idle.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "preset/fault.h"
#include "preset/json.h"
#include "scene/describe.h"

namespace frond {

namespace {

/// A property, and the settings that heed it.
struct Heeded {
  std::string_view pointer;
  std::initializer_list<Setting> settings;
};

const Heeded kHeeded[] = {
    {"/scene/water", {Setting::underwater}},
    {"/scene/studio", {Setting::studio}},
    {"/scene/meadow", {Setting::meadow, Setting::garden, Setting::forest}},
    {"/scene/meadow/zenith", {Setting::meadow}},
    {"/scene/meadow/horizon", {Setting::meadow}},
    {"/scene/meadow/sun", {Setting::meadow}},
    {"/scene/meadow/grass", {Setting::meadow, Setting::garden}},
    {"/scene/meadow/blade", {Setting::meadow, Setting::garden}},
    {"/scene/meadow/blades", {Setting::meadow, Setting::garden}},
    {"/scene/meadow/extent", {Setting::meadow, Setting::garden}},
    {"/scene/meadow/flowers", {Setting::meadow, Setting::garden}},
    {"/scene/garden", {Setting::garden}},
    {"/scene/forest", {Setting::forest}},
    {"/scene/floor", {Setting::underwater, Setting::meadow, Setting::garden}},
    {"/scene/floor/stones", {Setting::underwater}},
    {"/scene/floor/stone_size", {Setting::underwater}},
    {"/scene/floor/extent", {Setting::underwater}},
};

/// What of `place` sown copies and ivy pass over.
constexpr std::string_view kScatter[] = {"center", "inner", "radius", "spacing", "rock"};
constexpr std::string_view kStance[] = {"size_variation", "turn", "turn_variation", "lean"};

/// An angle that is given as so few degrees was meant as radians.
constexpr double kRadians = 1.5;

std::string_view name_of(Setting setting) {
  auto row = std::ranges::find(kSettings, setting, &Choice<Setting>::value);
  return row == std::end(kSettings) ? "" : row->name;
}

class Finder {
 public:
  Finder(const Preset& preset, const std::string& file_name) : preset_(preset), file_name_(file_name) {}

  Errors find() {
    const Value* scene = preset_.written->find("scene");
    const Value* setting = scene ? scene->find("setting") : nullptr;
    bool set = setting && setting->origin.line == 0;
    for (const Heeded& heeded : kHeeded) {
      const Value* value = at(*preset_.written, heeded.pointer);
      // A setting of the command line leaves what the file has for its own.
      if (value && (!set || value->origin.line == 0)) check(heeded, *value);
    }
    const Value* organisms = preset_.written->find("organisms");
    for (std::size_t i = 0; i < preset_.organisms.size(); ++i)
      check(preset_.organisms[i], organisms->items[i], fmt::format("/organisms/{}", i));
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
    if (own(value)) add({value.origin, pointer, fmt::format("does nothing here: {}", why)});
  }

  /// What the defaults say is said once.
  void add(Fault fault) { notes_.add(std::move(fault)); }

  void check(const Heeded& heeded, const Value& value) {
    Setting setting = preset_.stage.setting;
    if (std::ranges::find(heeded.settings, setting) != heeded.settings.end()) return;
    // The whole was told of.
    if (!told_.empty() && heeded.pointer.starts_with(told_ + "/")) return;
    told_ = heeded.pointer;
    std::string names;
    for (Setting other : heeded.settings)
      names += fmt::format("{}{}", names.empty() ? "" : ", ", name_of(other));
    note(value, told_, fmt::format("the setting is {}; it is for {}", name_of(setting), names));
  }

  void check(const Organism& organism, const Value& written, const std::string& pointer) {
    auto idle = [&](std::string_view name, std::string_view why) {
      if (const Value* value = at(written, fmt::format("/place/{}", name)))
        note(*value, fmt::format("{}/place/{}", pointer, name), why);
    };
    bool ivy = std::holds_alternative<IvyParams>(organism.body);
    if (ivy || organism.sown)
      for (std::string_view name : kScatter)
        idle(name,
             ivy ? "ivy roots at place.at, or anywhere on its host" : "sown.where says where copies stand");
    if (ivy)
      for (std::string_view name : kStance) idle(name, "ivy takes the shape of its host");
    if (!ivy && !organism.sown && organism.place.rock > 0 && preset_.stage.setting != Setting::underwater)
      idle("rock", "rocks lie under water only");
    check_motion(written, pointer, "wave", "amplitude");
    check_motion(written, pointer, "food", "strength");
    const Value* strength = at(written, "/food/strength");
    if (strength && strength->number > 0 && strength->number <= kRadians)
      add({strength->origin, pointer + "/food/strength",
           fmt::format("is an angle in degrees; {:g} radians would be {:.6g}", strength->number,
                       degrees(strength->number))});
  }

  /// What moves only by a number that nobody gave.
  void check_motion(const Value& written, const std::string& pointer, std::string_view motion,
                    std::string_view strength) {
    const Value* value = written.find(motion);
    if (!value || value->members.empty() || value->find(strength)) return;
    note(*value, fmt::format("{}/{}", pointer, motion),
         fmt::format("its {} is not given and so is 0", strength));
  }

  const Preset& preset_;
  const std::string& file_name_;
  std::string told_;
  Faults notes_;
};

}  // namespace

Errors idle_settings(const Preset& preset, const std::string& file_name) {
  return Finder(preset, file_name).find();
}

}  // namespace frond
