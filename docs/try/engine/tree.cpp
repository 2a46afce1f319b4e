#include <algorithm>
#include <memory>

#include "grove/age.h"
#include "grove/earlier.h"
#include "organisms/tree/tree.h"
#include "preset/reader.h"
#include "try/engine/answers.h"
#include "try/engine/lit_tree.h"

// A tree that grows for light, for the page. It is grown once, with its history, and shown at any age.

namespace frond {

namespace {

const Vec3 kSun = glm::normalize(Vec3(-0.55f, 0.75f, 0.5f));

/// The tree of a preset as it has grown up.
struct GrownUp {
  std::string json;
  double seed = 0, most = 0;
  TreeParams params;
  Seed planting;
  Grove grove;
  std::vector<int> cycles;  ///< gone through by each year of its life, from 0 on
};

Result<TreeParams> read_tree(const std::string& json) {
  Result<Document> document = parse_json(json, "preset");
  if (!document) return document.errors();
  Value* organisms = document->root.find("organisms");
  const Value* kind = organisms && !organisms->items.empty() ? organisms->items[0].find("kind") : nullptr;
  if (!kind || kind->text != "tree") return Error{"preset", "its first organism is no tree"};
  Document tree{organisms->items[0]};
  for (const char* other : {"kind", "name", "count", "place", "body"}) tree.root.remove(other);
  return read_preset<TreeParams>(tree);
}

/// Grows it with the random numbers of a scene whose first organism it is, on level ground, until so many
/// internodes stand.
Result<GrownUp> grow_up(const std::string& json, double seed, double most) {
  Result<TreeParams> read = read_tree(json);
  if (!read) return read.errors();
  GrownUp grown{json, seed, most, std::move(*read), {}, {}, {}};
  TreeParams& params = grown.params;
  params.budget.internodes = static_cast<int>(most);
  Seed scene{static_cast<std::uint64_t>(seed)};
  grown.planting = scene.child("organism", 0).child("instance", 0);
  TreeSite site{&params, Vec3(0), Quat(1, 0, 0, 0), 1, grown.planting.child("grow")};
  grown.grove = grow_trees({&site, 1}, true, scene.child("weather"));
  for (int year = 0, cycles = 0; year <= params.years && cycles <= grown.grove.cycles; ++year) {
    grown.cycles.push_back(cycles);
    cycles = growth_cycles(params.species, year + 1);
  }
  make_few_triangles(params.leaves);
  if (!params.season) params.season = Seasons{.evergreen = params.leaves.sprig.kind == SprigKind::needles};
  return grown;
}

val arrays(const std::vector<std::vector<float>>& all) {
  val out = val::array();
  for (const std::vector<float>& one : all) out.call<void>("push", copied(one));
  return out;
}

/// The tree at an age in years and a time of the year, 0..1: the one that a preset with these `years` shows.
val tree_at(const std::string& json, double seed, double most, int years, double time) {
  static std::unique_ptr<GrownUp> grown;  // the last one: ages are looked up in it
  if (!grown || grown->json != json || grown->seed != seed || grown->most != most) {
    Result<GrownUp> fresh = grow_up(json, seed, most);
    if (!fresh) return failed(fresh.errors());
    grown = std::make_unique<GrownUp>(std::move(*fresh));
  }
  auto age = static_cast<std::size_t>(std::clamp<int>(years, 1, static_cast<int>(grown->cycles.size()) - 1));
  int cycles = grown->cycles[age];
  GrownTree tree = earlier(grown->grove.trees[0], cycles);
  Model model = tree_model(grown->params, tree, cycle_at({}, cycles, 0), {}, grown->planting.child("look"));
  Seasons seasons = *grown->params.season;
  seasons.at = Animated<double>{time};
  in_season(model, seasons, 0, grown->planting.child("season"), [](double, double) { return 0.0; });
  LitTree lit = lit_tree(model, grown->params, kSun);
  val out = failed({});
  out.set("segments", copied(lit.segments));
  out.set("shapes", arrays(lit.shapes)), out.set("organs", arrays(lit.organs));
  out.set("ground", copied(lit.ground)), out.set("groundHalf", lit.ground_half);
  val sun = val::array();
  for (int k = 0; k < 3; ++k) sun.call<void>("push", kSun[k]);
  out.set("sun", sun);
  out.set("cycles", copied(grown->cycles));
  const Size& size = tree.sizes.back();
  out.set("internodes", static_cast<double>(size.internodes));
  out.set("height", size.height), out.set("stem", size.breast_diameter);
  return out;
}

}  // namespace

}  // namespace frond

EMSCRIPTEN_BINDINGS(frond_tree) { emscripten::function("tree", &frond::tree_at); }
