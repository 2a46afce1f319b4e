#include "scene/preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "core/assets.h"
#include "preset/fault.h"
#include "preset/json.h"
#include "preset/merge.h"
#include "preset/override.h"
#include "preset/palettes.h"
#include "preset/reader.h"
#include "preset/schema.h"
#include "scene/bounds.h"
#include "scene/camera_move.h"
#include "scene/describe.h"
#include "scene/furnish.h"
#include "scene/named_preset.h"
#include "scene/unused_properties.h"
#include "scene/upgrade.h"
#include "settings/settings.h"

namespace frond {
namespace {

/// A fault at the pointer inside of an organism.
Fault organism_fault(const Value& organism, std::size_t index, std::string_view pointer, std::string what) {
  return {origin_at(organism, pointer), fmt::format("/organisms/{}{}", index, pointer), std::move(what)};
}

/// What is wrong with the edits of an organism; each `where` is a pointer below it.
Errors edit_faults(const Organism& organism) {
  const Grower& grower = *organism.grower;
  if (organism.edits.empty()) return {};
  if (const GrowerTraits traits = grower.traits(); !traits.branches || traits.creeps())
    return {{"/edits", "are of branches; expected a kind that has them and does not creep"}};
  Errors errors;
  for (std::size_t i = 0; i < organism.edits.size(); ++i) {
    const Edit& edit = organism.edits[i];
    auto add = [&](std::string_view name, std::string what) {
      errors.push_back({fmt::format("/edits/{}{}", i, name), std::move(what)});
    };
    const int given = edit.cut.has_value() + edit.bend.has_value() + edit.strength.has_value() +
                      (edit.bare ? 1 : 0) + edit.bark.has_value();
    if (given != 1)
      add("", fmt::format("has {} of cut, bend, strength, bare and bark; expected one of them", given));
    if (edit.bark && !grower.appearance().look.branches.plant())
      add("/bark", "is of plants; expected an edit of a kind whose branches have bark");
    if (edit.dated() && !grower.perennial())
      add("/cut", "names a year; expected true, or the kind tree, which grows over years");
    if (edit.bend && edit.at.share == 0)
      add("/at", "is where the limb is held; expected a place farther along it to pull at, as \"3:0.8\"");
  }
  return errors;
}

/// Edits of plants that there are not.
Errors edit_warnings(const Organism& organism) {
  Errors warnings;
  for (std::size_t i = 0; i < organism.edits.size(); ++i) {
    const auto& plant = organism.edits[i].plant;
    if (plant && (organism.sown || *plant >= static_cast<std::size_t>(organism.count)))
      warnings.push_back({fmt::format("/edits/{}/plant", i),
                          organism.sown
                              ? "does nothing: what is sown has copies only"
                              : fmt::format("finds no plant: there are {}, counted from 0", organism.count)});
  }
  return warnings;
}

/// Finds what is wrong with an organism as a whole and with where it stands: within `reach` metres.
void check_organism(const Organism& organism, const Value& written, std::size_t index, double reach,
                    Faults& faults, Faults& warnings) {
  for (std::size_t i = 0; i < organism.place.at.size(); ++i)
    if (glm::length(organism.place.at[i]) > reach)
      faults.add(organism_fault(
          written, index, fmt::format("/place/at/{}", i),
          fmt::format(
              "lies off the ground, which reaches {:g} m here; expected a place within that of the middle",
              reach)));
  if (organism.sown && organism.grower->traits().creeps())
    faults.add(organism_fault(written, index, "/sown",
                              "ivy cannot be sown, for it grows on what stands; expected another kind"));
  auto add = [&](Faults& list, const Errors& errors) {
    for (const Error& error : errors) list.add(organism_fault(written, index, error.where, error.what));
  };
  const Review review = organism.grower->review();
  add(faults, review.faults);
  if (review.faults.empty()) add(warnings, review.warnings);
  add(faults, edit_faults(organism));
  if (const Growth growth = organism.grower->appearance().motion.growth; growth.rate > 0 && !growth.by_rate())
    faults.add(organism_fault(written, index, "/growth/rate",
                              "found no years_a_second beside it; expected how many years pass in a second"));
  if (organism.courses.health && !organism.grower->traits().lives())
    faults.add(
        organism_fault(written, index, "/health", "is for what lives; expected none, or another kind"));
  add(warnings, edit_warnings(organism));
}

/// The names of the organisms that are so.
template <class Is>
std::vector<std::string_view> names_of(const Preset& preset, const Is& is) {
  std::vector<std::string_view> names;
  for (const Organism& organism : preset.organisms)
    if (!organism.name.empty() && is(organism)) names.push_back(organism.name);
  return names;
}

/// Adds a fault where a name is none of those: `what` is wrong then, and `none` is expected where there are
/// no names.
void require_name(const std::vector<std::string_view>& names, const std::string& name, const Value& root,
                  const std::string& pointer, std::string what, std::string_view none, Faults& faults) {
  if (std::ranges::find(names, name) != names.end()) return;
  what += names.empty() ? std::string(none) : expected_names(name, names);
  faults.add({origin_at(root, pointer), pointer, std::move(what)});
}

/// What names hosts that are not there, or that are no bodies.
void check_hosts(const Preset& preset, Faults& faults) {
  auto names = names_of(preset, [](const Organism& o) { return !o.sown && !o.grower->traits().creeps(); });
  for (std::size_t i = 0; i < preset.organisms.size(); ++i) {
    auto require_all = [&](std::string_view pointer, const std::vector<std::string>& hosts) {
      for (std::size_t k = 0; k < hosts.size(); ++k)
        require_name(names, hosts[k], *preset.written, fmt::format("/organisms/{}{}/{}", i, pointer, k),
                     fmt::format("no organism \"{}\" to grow on", hosts[k]),
                     "; expected the \"name\" of another organism, and none here has one", faults);
    };
    const Organism& organism = preset.organisms[i];
    if (const std::vector<std::string>* hosts = organism.grower->traits().hosts) require_all("/on", *hosts);
    if (organism.sown || organism.grower->traits().stands_on_bodies())
      require_all("/place/on", organism.place.on);
  }
}

/// What the camera is to fit or to focus on, or events concern, and is not there.
void check_named(const Preset& preset, const Value& root, Faults& faults) {
  auto names = names_of(preset, [](const Organism&) { return true; });
  auto require_one = [&](const std::string& name, const std::string& pointer, std::string_view to) {
    require_name(names, name, root, pointer, fmt::format("no organism \"{}\" to {}", name, to),
                 "; expected the \"name\" of one, and none here has one", faults);
  };
  for (std::size_t i = 0; i < preset.events.size(); ++i) {
    const Event& event = preset.events[i];
    if (event.cut && !event.cut->entry.empty())
      require_one(event.cut->entry, fmt::format("/events/{}/cut/entry", i), "fell");
    if (event.prune && !event.prune->entry.empty())
      require_one(event.prune->entry, fmt::format("/events/{}/prune/entry", i), "prune");
  }
  const std::optional<Focus>& focus = preset.setup.camera.focus;
  if (focus && !focus->organism.empty()) require_one(focus->organism, "/scene/camera/focus", "focus on");
  names.insert(names.begin(), kFitAll);
  for (std::size_t i = 0; i < preset.setup.camera.fit.size(); ++i)
    require_one(preset.setup.camera.fit[i], fmt::format("/scene/camera/fit/{}", i), "fit");
}

/// An organism that trees or colonies are to be drawn as and that is not there, or is not sown.
void check_drawn_as(const Preset& preset, const std::string& name, const std::string& pointer,
                    std::string_view what, Faults& faults) {
  require_name(names_of(preset, [](const Organism& o) { return o.sown.has_value(); }), name, *preset.written,
               pointer, fmt::format("no organism \"{}\" that is sown, to draw these {} as", name, what),
               "; expected the \"name\" of one with \"sown\"", faults);
}

/// A stand or a reef at `where`, whose own faults are `found`.
void check_dynamics(const Preset& preset, const std::string& where, const auto& text, Errors found,
                    std::string_view what, Faults& faults) {
  for (Error& error : found) {
    std::string pointer = where + error.where;
    faults.add({origin_at(*preset.written, pointer), pointer, std::move(error.what)});
  }
  for (std::size_t i = 0; i < text.species.size(); ++i)
    if (const std::string& name = text.species[i].organism; !name.empty())
      check_drawn_as(preset, name, fmt::format("{}/species/{}/organism", where, i), what, faults);
}

void check_stand_or_reef(const Preset& preset, Faults& faults) {
  const auto& [stand, reef] = std::tie(preset.stand, preset.reef);
  if (stand) check_dynamics(preset, "/stand", *stand, stand_faults(*stand), "trees", faults);
  if (reef) check_dynamics(preset, "/reef", *reef, reef_faults(*reef), "colonies", faults);
  if (stand && reef)
    faults.add(
        {origin_at(*preset.written, "/reef"), "/reef", "found beside a stand; expected one of the two"});
}

/// The trees of the far land, and climates in which nothing would end.
void check_altitudes(const Preset& preset, Faults& faults) {
  if (const auto& far = preset.setup.far)
    for (std::size_t i = 0; i < far->trees.size(); ++i)
      check_drawn_as(preset, far->trees[i], fmt::format("/scene/far/trees/{}", i), "trees", faults);
  for (std::size_t i = 0; i < preset.organisms.size(); ++i) {
    const std::optional<Sowing>& sown = preset.organisms[i].sown;
    if (!sown || !sown->where.warmth || sown->where.warmth->full > sown->where.warmth->least) continue;
    std::string pointer = fmt::format("/organisms/{}/sown/where/warmth/full", i);
    faults.add({origin_at(*preset.written, pointer), pointer,
                fmt::format("found {:g}; expected more than `least`, {:g}", sown->where.warmth->full,
                            sown->where.warmth->least)});
  }
}

/// What would be too much of something.
void check_bounds(const Preset& preset, Faults& faults) {
  Errors errors = settings()[preset.setup.setting].answers.find_faults(preset.setup, preset.film);
  for (Error& error : errors) error.where.insert(0, "/scene");
  for (auto found : {too_much_together, without_room})
    for (Error& error : found(preset)) errors.push_back(std::move(error));
  for (Error& error : errors)
    faults.add({origin_at(*preset.written, error.where), error.where, std::move(error.what)});
}

/// What no picture can be made of although each value is one that may be.
void check_setup(const Camera& camera, const Value& root, Faults& faults) {
  const std::string pointer = "/scene/camera/look_at";
  for (const auto* path : {&camera.location, &camera.look_at})
    for (const auto& key : path->keys())
      if (glm::distance(camera.location.at(key.time), camera.look_at.at(key.time)) < 1e-4f)
        return faults.add({origin_at(root, pointer), pointer,
                           "is where the camera stands; expected another place to look at"});
}

/// The time of the year that the scene tells is that of all seasons that have none of their own.
void pass_on_year(Value& root) {
  const Value* scene = root.find("scene");
  const Value* year = scene && scene->is(Value::Type::object) ? scene->find("year") : nullptr;
  // What is wrong with it is told once, where it stands.
  if (!year || !Reader().animated_at(*year, {.min = -1000, .max = 1000}, Animated<double>{})) return;
  Value at = make_object(), season = make_object(), all = make_object();
  at.set("at", *year);
  season.set("season", std::move(at));
  all.set("defaults", std::move(season));
  root = overlay(all, root);
}

/// The time of the last frame of a film that is not read yet, seconds; 0 of a still and where it is wrong.
double last_frame(const Value& root) {
  Value own = make_object();
  if (const Value* written = root.find("film")) own = *written;
  Preset preset;
  Reader().read_root(make_object().set("film", own), preset);
  return preset.film.time(preset.film.frames);
}

/// Growth that ends with the film lasts from its start to the last frame, the last of those that begin later
/// by chance included. In a still all has grown.
void end_growth_with_film(Value& root) {
  double last = last_frame(root);
  auto number = [](const Value& growth, const char* name) {
    const Value* value = growth.find(name);
    return value && value->is(Value::Type::number) ? value->number : 0;
  };
  auto end = [&](Value& holder, const Value& whole) {
    const Value* growth = whole.find("growth");
    const Value* asked = growth ? growth->find("to_end") : nullptr;
    if (!asked || !asked->boolean || !holder.find("growth")) return;
    double lasts = std::max(1e-3, last - number(*growth, "start") - number(*growth, "stagger"));
    Value own = make_object();
    own.set("duration", make_number(last > 0 ? lasts : 0));
    holder = overlay(holder, make_object().set("growth", own));
  };
  Value* organisms = root.find("organisms");
  for (std::size_t i = 0; organisms && i < organisms->items.size(); ++i)
    if (organisms->items[i].is(Value::Type::object)) end(organisms->items[i], merged_organism(root, i));
  if (Value* defaults = root.find("defaults")) end(*defaults, *defaults);
}

/// The document with the defaults in its organisms.
Value with_defaults(Value root) {
  Value* organisms = root.find("organisms");
  for (std::size_t i = 0; organisms && i < organisms->items.size(); ++i)
    organisms->items[i] = merged_organism(root, i);
  return root;
}

}  // namespace

Error fault_at(const Preset& preset, const std::string& pointer, std::string what) {
  Origin origin = preset.written ? origin_at(*preset.written, pointer) : Origin{};
  return Fault{std::move(origin), pointer, std::move(what)}.error();
}

Result<Preset> read_preset(std::string_view text, const std::string& file_name,
                           const std::vector<std::string>& sets,
                           const std::optional<std::filesystem::path>& only) {
  Result<Document> document = parse_json(text, file_name);
  if (!document) return document.errors();
  Assets assets(file_name, only);
  bool old = !upgrade_preset(text, document->root, [&](const std::string& name) {
                return assets.read(name).ok();
              }).changes.empty();
  Errors errors;
  auto set_all = [&](std::string_view beginning) {
    for (const std::string& set : sets)
      if (set.starts_with(beginning))
        for (Error& error : apply_set(*document, set)) errors.push_back(std::move(error));
    return errors.empty();
  };
  // The base may be set, too, and all else is set over it.
  if (!set_all("/base=")) return errors;
  std::vector<std::filesystem::path> read;
  assets.note_in(read);
  errors = lay_on_base(document->root, file_name, assets);
  if (!errors.empty() || !set_all("")) return errors;
  if (errors = use_palettes(document->root); !errors.empty()) return errors;
  if (errors = lay_on_species(document->root, file_name, assets); !errors.empty()) return errors;
  pass_on_year(document->root);
  end_growth_with_film(document->root);

  Faults faults, warnings;
  Result<Preset> preset = read_preset<Preset>(*document, &warnings, &assets);
  if (!preset) return preset;
  preset->setup.camera = keyed_move(preset->setup.camera, preset->film);
  preset->film.air = is_misty(preset->setup);
  for (Event& event : preset->events)
    if (event.cut) event.cut->by_own = preset->version >= 2;
  preset->text = serialize(document->root);
  preset->files = std::move(read);
  preset->old = old;
  preset->written = std::make_shared<const Value>(with_defaults(document->root));
  double reach = settings()[preset->setup.setting].answers.extent(preset->setup).reach;
  for (Error& error : furnish(*preset, reach, warnings))
    faults.add({origin_at(*preset->written, error.where), error.where, std::move(error.what)});
  check_stand_or_reef(*preset, faults);
  check_altitudes(*preset, faults);
  for (std::size_t i = 0; i < preset->organisms.size(); ++i) {
    const Value& written = preset->written->find("organisms")->items[i];
    check_organism(preset->organisms[i], written, i, reach, faults, warnings);
  }
  check_hosts(*preset, faults);
  check_bounds(*preset, faults);
  check_setup(preset->setup.camera, document->root, faults);
  check_named(*preset, document->root, faults);
  if (!faults.list().empty()) return faults.errors();
  preset->notes = warnings.errors();
  for (Error& unused : unused_properties(*preset, file_name)) preset->notes.push_back(std::move(unused));
  return preset;
}

const Value& preset_schema() {
  static const Value schema = file_schema<Preset>("Frond preset", "A film or a still of things that grow.");
  return schema;
}

}  // namespace frond
