#include "scene/preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/assets.h"
#include "preset/fault.h"
#include "preset/json.h"
#include "preset/merge.h"
#include "preset/override.h"
#include "preset/reader.h"
#include "preset/schema.h"
#include "scene/bounds.h"
#include "scene/describe.h"
#include "scene/idle.h"

namespace frond {
namespace {

struct RuleList {
  std::string_view name;
  std::vector<GrammarText::Rule> GrammarText::*rules;
};

constexpr RuleList kRuleLists[] = {{"rules", &GrammarText::rules},
                                   {"decomposition", &GrammarText::decomposition},
                                   {"interpretation", &GrammarText::interpretation}};

/// An organism with the defaults behind it, as it was read.
Value merged_organism(const Value& root, std::size_t index) {
  std::vector<std::string> force;
  if (const Value* names = root.find("force"))
    for (const Value& name : names->items) force.push_back(name.text);
  const Value* defaults = root.find("defaults");
  return merge(defaults ? *defaults : make_object(), root.find("organisms")->items[index], force);
}

/// A fault at the pointer inside of an organism.
Fault organism_fault(const Value& organism, std::size_t index, std::string_view pointer, std::string what) {
  return {origin_at(organism, pointer), fmt::format("/organisms/{}{}", index, pointer), std::move(what)};
}

/// What stands between the first backquotes of a text.
std::string_view in_backquotes(std::string_view text) {
  std::size_t begin = std::min(text.find('`'), text.size());
  text.remove_prefix(std::min(begin + 1, text.size()));
  return text.substr(0, text.find('`'));
}

/// The property of a grammar that an error of compile() is about: "/rules/2", "/axiom", or "" where it does
/// not say. Rules must have been placed.
std::string grammar_pointer(const GrammarText& grammar, const Error& error) {
  for (const RuleList& list : kRuleLists) {
    const std::vector<GrammarText::Rule>& rules = grammar.*list.rules;
    auto rule = std::ranges::find(rules, error.where, &GrammarText::Rule::where);
    if (rule != rules.end()) return fmt::format("/grammar/{}/{}", list.name, rule - rules.begin());
  }
  if (error.where.starts_with('/')) return error.where;
  if (error.where.starts_with("constant `"))
    return pointer_step("/grammar/constants", in_backquotes(error.where));
  if (!error.where.empty()) return pointer_step("/grammar", error.where);
  // A number that is out of range is named first of all.
  return error.what.starts_with('`') ? pointer_step("/grammar", in_backquotes(error.what)) : "/grammar";
}

/// Rules that a coral does not grow by, or that it lacks. Defaults may hold rules for other corals.
void check_form(const CoralParams& coral, const Value& written, const Value& own_part, std::size_t index,
                Faults& faults) {
  bool own = coral.form == CoralForm::own;
  if (own && !written.find("grammar"))
    faults.add(organism_fault(written, index, "/form", "found \"own\" and no rules; expected a \"grammar\""));
  if (!own && own_part.find("grammar"))
    faults.add(
        organism_fault(written, index, "/grammar",
                       "found rules, but the coral grows by those of its form; expected \"form\": \"own\""));
}

/// Tells the rules where they stand and finds what is wrong with them, and with where it stands: within
/// `ground` metres.
void check_organism(Organism& organism, const Value& written, std::size_t index, double ground,
                    Faults& faults, Faults& doubtful) {
  auto* coral = std::get_if<CoralParams>(&organism.body);
  auto* plant = std::get_if<PlantParams>(&organism.body);
  GrammarText* grammar = plant                                    ? &plant->grammar
                         : coral && coral->form == CoralForm::own ? &coral->grammar
                                                                  : nullptr;
  if (grammar || coral) {
    GrammarText& text = grammar ? *grammar : coral->grammar;
    text.where = organism_fault(written, index, grammar ? "/grammar" : "/steps", "").error().where;
  }
  if (grammar) {
    for (const RuleList& list : kRuleLists) {
      std::size_t i = 0;
      for (GrammarText::Rule& rule : grammar->*list.rules) {
        std::string pointer = fmt::format("/grammar/{}/{}", list.name, i++);
        rule.where = organism_fault(written, index, pointer, "").error().where;
      }
    }
  }
  for (std::size_t i = 0; i < organism.place.at.size(); ++i)
    if (glm::length(organism.place.at[i]) > ground)
      faults.add(organism_fault(
          written, index, fmt::format("/place/at/{}", i),
          fmt::format(
              "lies off the ground, which reaches {:g} m here; expected a place within that of the middle",
              ground)));
  if (organism.sown && std::holds_alternative<IvyParams>(organism.body))
    faults.add(organism_fault(written, index, "/sown",
                              "ivy cannot be sown, for it grows on what stands; expected another kind"));
  auto add = [&](Faults& list, const Errors& errors) {
    for (const Error& error : errors) {
      std::string pointer = grammar                        ? grammar_pointer(*grammar, error)
                            : error.where.starts_with('/') ? error.where
                                                           : "";
      list.add(organism_fault(written, index, pointer, error.what));
    }
  };
  Errors errors = check(organism);
  add(faults, errors);
  if (errors.empty()) add(doubtful, doubts(organism));
}

/// Why ivy cannot grow on what it names.
std::string host_fault(const std::string& name, const std::vector<std::string_view>& names) {
  std::string what = fmt::format("no organism \"{}\" to grow on", name);
  if (names.empty()) return what + "; expected the \"name\" of another organism, and none here has one";
  return what + expected_names(name, names);
}

/// Ivy that names what is not there, or what is no body.
void check_hosts(const Preset& preset, Faults& faults) {
  std::vector<std::string_view> names;
  for (const Organism& organism : preset.organisms)
    if (!organism.name.empty() && !organism.sown && !std::holds_alternative<IvyParams>(organism.body))
      names.push_back(organism.name);
  for (std::size_t i = 0; i < preset.organisms.size(); ++i) {
    const auto* ivy = std::get_if<IvyParams>(&preset.organisms[i].body);
    if (!ivy) continue;
    const Value& written = preset.written->find("organisms")->items[i];
    if (ivy->crawl.lure != Lure::point && ivy->crawl.bias > 0 && glm::length(ivy->crawl.toward) < 1e-3f)
      faults.add(organism_fault(written, i, "/crawl/toward",
                                "found a vector of length 0; expected the direction that strands turn to"));
    for (std::size_t k = 0; k < ivy->on.size(); ++k)
      if (std::ranges::find(names, ivy->on[k]) == names.end())
        faults.add(organism_fault(written, i, fmt::format("/on/{}", k), host_fault(ivy->on[k], names)));
  }
}

/// What would be too much of something.
void check_bounds(const Preset& preset, Faults& faults) {
  std::vector<Excess> all = beyond_bounds(preset);
  for (Excess& excess : without_room(preset)) all.push_back(std::move(excess));
  for (Excess& excess : all)
    faults.add({origin_at(*preset.written, excess.pointer), excess.pointer, std::move(excess.what)});
}

/// What no picture can be made of although each value is one that may be.
void check_stage(const Stage& stage, const Value& root, Faults& faults) {
  auto fault = [&](const char* pointer, const char* what) {
    faults.add({origin_at(root, pointer), pointer, what});
  };
  std::vector<double> times;
  for (const auto& key : stage.camera.location.keys()) times.push_back(key.time);
  for (const auto& key : stage.camera.look_at.keys()) times.push_back(key.time);
  for (double time : times)
    if (glm::distance(stage.camera.location.at(time), stage.camera.look_at.at(time)) < 1e-4f)
      return fault("/scene/camera/look_at", "is where the camera stands; expected another place to look at");
}

constexpr int kMostBases = 8;

/// The names of a preset's properties, as Reader tells them of one that is none.
std::vector<std::string_view> preset_names() {
  Value probe = make_object();
  probe.set("", make_boolean(true));
  Preset preset;
  Reader reader;
  reader.read_root(probe, preset);
  std::vector<std::string_view> names = reader.faults().list().front().names;
  names.push_back("$schema");
  return names;
}

/// A file that was named as a base. Where it is no preset, nothing that stands in it is shown: it may be a
/// file that was not meant to be read.
Result<Document> read_base(const NamedFile& file) {
  std::string path = file.path.string();
  std::string hint = fmt::format("; expected a preset, see `frond check {}`", path);
  Result<Document> base = parse_json(file.text, path);
  if (!base) {
    std::string where = base.errors().front().where;
    return Error{where.substr(0, where.find(": /")), "is no JSON" + hint};
  }
  std::vector<std::string_view> names = preset_names();
  const Value& root = base->root;
  if (!root.is(Value::Type::object)) return Error{root.origin.text(), "is no object" + hint};
  for (const Member& member : root.members)
    if (std::ranges::find(names, member.name) == names.end())
      return Error{member.origin.text(), "is a name that presets do not have" + hint};
  return base;
}

/// Lays a preset over the one that it names as its base, and that over its own.
Errors lay_on_base(Value& root, const std::string& file_name, const Assets& assets, int depth = 0) {
  const Value* base = root.find("base");
  if (!base) return {};
  auto fault = [&](std::string what) {
    return Errors{Fault{base->origin, "/base", std::move(what)}.error()};
  };
  // What is no text is told where all else is read, but for that of a base, which goes.
  if (!base->is(Value::Type::text))
    return depth == 0 ? Errors{} : fault(fmt::format("found {}; expected a text", found_text(*base)));
  if (base->text.empty()) return {};
  if (depth == kMostBases) return fault("more than 8 bases on each other; is one its own?");
  Result<NamedFile> file = assets.read(base->text, std::filesystem::path(file_name).parent_path());
  if (!file) return fault(file.errors().front().what);
  Result<Document> below = read_base(*file);
  if (!below) return below.errors();
  if (Errors errors = lay_on_base(below->root, file->path.string(), assets, depth + 1); !errors.empty())
    return errors;
  below->root.remove("base");
  root = overlay(below->root, root);
  return {};
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
  Errors errors;
  auto set_all = [&](std::string_view beginning) {
    for (const std::string& set : sets)
      if (set.starts_with(beginning))
        for (Error& error : apply_set(*document, set)) errors.push_back(std::move(error));
    return errors.empty();
  };
  // The base may be set, too, and all else is set over it.
  if (!set_all("/base=")) return errors;
  errors = lay_on_base(document->root, file_name, Assets(file_name, only));
  if (!errors.empty() || !set_all("")) return errors;

  Faults faults, doubtful;
  Result<Preset> preset = read_preset<Preset>(*document, &doubtful);
  if (!preset) return preset;
  preset->text = serialize(document->root);
  preset->written = std::make_shared<const Value>(with_defaults(document->root));
  const Stage& stage = preset->stage;
  double ground = stage.setting == Setting::forest ? std::max(30.0, stage.forest.terrain.size) : 30;
  for (std::size_t i = 0; i < preset->organisms.size(); ++i) {
    Value written = preset->written->find("organisms")->items[i];
    if (const auto* coral = std::get_if<CoralParams>(&preset->organisms[i].body))
      check_form(*coral, written, document->root.find("organisms")->items[i], i, faults);
    check_organism(preset->organisms[i], written, i, ground, faults, doubtful);
    for (std::string_view other : {"name", "count", "place", "sown", "wave", "growth"}) written.remove(other);
    preset->organisms[i].text = serialize(written);
  }
  check_hosts(*preset, faults);
  check_bounds(*preset, faults);
  check_stage(preset->stage, document->root, faults);
  if (!faults.list().empty()) return faults.errors();
  preset->notes = doubtful.errors();
  for (Error& idle : idle_settings(*preset, file_name)) preset->notes.push_back(std::move(idle));
  return preset;
}

std::string preset_schema() {
  return schema_text<Preset>("Frond preset", "A film or a still of things that grow.");
}

}  // namespace frond
