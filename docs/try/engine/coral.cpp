#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "appearance/skin_colors.h"
#include "core/linear.h"
#include "organisms/describe.h"
#include "organisms/kinds.h"
#include "preset/merge.h"
#include "preset/palettes.h"
#include "preset/reader.h"
#include "try/engine/answers.h"
#include "try/engine/lit_coral.h"

// A coral of a preset, for the page. It is grown once and shown at any share of its growth.

namespace frond {

namespace {

/// What is read of a preset here: what grows, and which of the random numbers it takes.
struct Corals {
  int version = 1;
  double seed = 1;
  std::vector<Organism> organisms;
};

void describe(Properties& v, Corals& c) {
  v.integer("version", c.version, {.min = 1, .max = 2}, "");
  v.number("seed", c.seed, {.min = 0, .max = 9007199254740991.0}, "");
  v.inheriting_list({}, c.organisms, organism_kinds(), "");
}

/// A coral as it has grown, or a rougher version of it.
struct GrownCoral {
  std::string json;
  double share = 0;
  Errors notes;
  Look look;
  Material material;
  Model model;
};

Fault organism_fault(const Value& root, const Error& error) {
  std::string pointer = "/organisms/0" + error.where;
  return {origin_at(root, pointer), pointer, error.what};
}

Errors placed_in(const Value& root, const Errors& errors) {
  Faults faults;
  for (const Error& error : errors) faults.add(organism_fault(root, error));
  return faults.errors();
}

/// The text of a preset without what is said of film and scene, which the program reads.
Result<Document> read_text(const std::string& json, const std::string& name) {
  Result<Document> document = parse_json(json, name);
  if (!document) return document.errors();
  if (Errors errors = use_palettes(document->root); !errors.empty()) return errors;
  std::vector<std::string> others;
  for (const Member& member : document->root.members)
    if (member.name != "organisms" && member.name != "defaults" && member.name != "force" &&
        member.name != "seed" && member.name != "version")
      others.push_back(member.name);
  for (const std::string& other : others) document->root.remove(other);
  return document;
}

/// The random numbers of the first place of the first entry, as the program draws them.
Seed planting_of(const Corals& corals, std::string_view kind) {
  Seed seed{static_cast<std::uint64_t>(corals.seed)};
  const std::string& name = corals.organisms[0].name;
  Seed entry =
      corals.version < 2
          ? seed.child("organism", 0)
          : seed.child("organism")
                .child((name.empty() ? "kind " : "name ") + (name.empty() ? std::string(kind) : name), 0);
  return entry.child("instance", 0);
}

/// Grows the first organism, in about `share` of the time where that is below 1.
Result<GrownCoral> grow_first(const std::string& json, const std::string& name, double share) {
  Result<Document> document = read_text(json, name);
  if (!document) return document.errors();
  const Value* list = document->root.find("organisms");
  if (!list || list->items.empty())
    return Error{name, "its first organism is no coral; expected one to grow here"};
  Faults warnings;
  Result<Corals> corals = read_preset<Corals>(*document, &warnings);
  if (!corals) return corals.errors();
  const Organism& first = corals->organisms[0];
  const auto& grower = static_cast<const LoneGrower&>(*first.grower);
  Review review = grower.review();
  if (!review.faults.empty()) return placed_in(document->root, review.faults);
  GrownCoral grown{json, share, warnings.errors(), {}, {}, {}};
  for (Error& warning : placed_in(document->root, review.warnings)) grown.notes.push_back(std::move(warning));
  if (corals->organisms.size() > 1)
    grown.notes.push_back(
        {name, fmt::format("only the first of {} organisms is grown here", corals->organisms.size())});
  if (!first.edits.empty()) grown.notes.push_back({name, "edits by hand are left to the program"});
  const Value* kind = list->items[0].find("kind");
  Seed planting = planting_of(*corals, kind ? kind->text : "");
  std::shared_ptr<const Grower> rough = share < 1 ? first.grower->coarse(share) : nullptr;
  const auto& used = static_cast<const LoneGrower&>(rough ? *rough : *first.grower);
  Result<Model> model = used.grow_alone(planting.child("grow"));
  if (!model) return placed_in(document->root, model.errors());
  Appearance appearance = first.grower->appearance();
  grown.look = appearance.look;
  grown.model = std::move(*model);
  if (!grown.model.solids.shapes.empty()) grown.material = grown.model.solids.shapes[0].material;
  if (const std::optional<Skin>& skin = grown.look.branches.skin)
    grown.material = {.color = srgb(old_skin(*skin).tissue),
                      .second = srgb(old_skin(*skin).pits),
                      .scale = skin->pores.cell,
                      .relief = skin->kind == SkinKind::fan ? 0.2 : skin->pores.depth};
  return grown;
}

val color_of(const Color& color) {
  val out = val::array();
  for (float part : {color.red, color.green, color.blue}) out.call<void>("push", part);
  return out;
}

/// The coral at a share of its growth, 0..1.
val coral_at(const std::string& json, const std::string& name, double share, double grown_to) {
  static std::unique_ptr<GrownCoral> grown;  // the last one
  if (!grown || grown->json != json || grown->share != share) {
    Result<GrownCoral> fresh = grow_first(json, name, share);
    if (!fresh) return failed(fresh.errors());
    grown = std::make_unique<GrownCoral>(std::move(*fresh));
  }
  LitCoral lit = lit_coral(grown->model, grown->look, static_cast<float>(std::clamp(grown_to, 0.02, 1.0)));
  val out = failed({});
  out.set("notes", list(grown->notes));
  out.set("segments", copied(lit.segments));
  out.set("places", copied(lit.places)), out.set("normals", copied(lit.normals));
  out.set("skin", copied(lit.skin)), out.set("corners", copied(lit.corners));
  out.set("ground", copied(lit.ground)), out.set("groundHalf", lit.ground_half);
  const Material& material = grown->material;
  out.set("matter", material.matter == Matter::meander  ? "valleys"
                    : material.matter == Matter::sponge ? "sponge"
                                                        : "cups");
  out.set("color", color_of(material.color)), out.set("second", color_of(material.second));
  out.set("cup", material.scale), out.set("relief", material.relief);
  Bounds box = bounds_of(grown->model);
  val size = val::array();
  for (int k = 0; k < 3; ++k) size.call<void>("push", box.size()[k]);
  out.set("size", size);
  return out;
}

}  // namespace

}  // namespace frond

EMSCRIPTEN_BINDINGS(frond_coral) { emscripten::function("coral", &frond::coral_at); }
