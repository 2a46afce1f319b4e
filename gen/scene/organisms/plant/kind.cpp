#include <fmt/format.h>

#include <algorithm>

#include "appearance/describe.h"
#include "appearance/picture_bounds.h"
#include "grammar/figure.h"
#include "grammar/kind.h"
#include "organisms/asking.h"
#include "organisms/describe_grammar.h"
#include "organisms/grammar_faults.h"
#include "organisms/kinds.h"
#include "organisms/plant/cpfg_plant.h"
#include "organisms/plant/describe_flower.h"
#include "organisms/plant/flower_organ.h"
#include "organisms/plant/organ_mesh.h"
#include "organisms/plant/organ_prototypes.h"
#include "organisms/plant/plant.h"

namespace frond {

inline constexpr Choice<OrganShape> kOrganShapes[] = {
    {"leaf", OrganShape::leaf, "folded along its midrib and bent"},
    {"petal", OrganShape::petal, "a single petal"},
    {"flower", OrganShape::flower, "petals round a heart"},
    {"bud", OrganShape::bud, "closed, in a calyx"},
    {"berry", OrganShape::berry, "round, on its foot"},
    {"ball", OrganShape::ball, "round about its middle"},
    {"obj", OrganShape::obj, "the mesh of a Wavefront OBJ file, its foot at the bottom"},
    {"sprig", OrganShape::sprig, "a twig with leaves in two rows"},
    {"frond", OrganShape::frond, "a feathered leaf of many leaflets, as of a palm or a fern"},
    {"picture", OrganShape::picture, "a leaf of a known outline, as its picture shows it"},
    {"grammar", OrganShape::grammar, "what a grammar of its own draws: a stem, leaflets and outlines"},
    {"diagram", OrganShape::diagram, "a whole flower by its floral diagram; a second parameter is its stage"},
    {"inflorescence", OrganShape::inflorescence,
     "many flowers on their stalks; a second parameter is its stage"}};

inline constexpr Choice<PlantOrigin> kPlantOrigins[] = {
    {"turtle", PlantOrigin::turtle, "where the turtle starts"},
    {"middle", PlantOrigin::middle, "below its middle, the lowest point on the ground"}};

void describe(Properties& v, OrganParams& o) {
  v.aspect(Aspect::look);
  v.text("symbol", o.symbol,
         "Its name in the grammar: L stands at ~L and at a bare L without rule or meaning");
  v.required("symbol");
  v.choice("shape", o.shape, kOrganShapes, "What the organ is");
  v.file(
      "file", o.file, [&](const NamedFile& file) { return load_organ_mesh(file, o); },
      "A mesh (OBJ, PLY, STL, GLB), named as seen from the preset's folder: y is up, the middle of its "
      "underside is its foot, its longest side becomes size; a picture that a material of an OBJ file names "
      "(map_Kd) is worn by texture coordinates, and colors, where given, multiply it. Needs \"shape\": "
      "\"obj\"",
      o.shape == OrganShape::obj);
  v.number("size", o.size, metres(0.00001, 1000), "Length; a parameter in the grammar multiplies it");
  v.list("colors", o.colors, Count{1, 64},
         "Colours of the organ; the turtle's colour index picks one, round and round. Needs shape other than "
         "picture");
  v.given("colors", o.own_colors);
  v.color("second", o.second,
          "Colour of a flower's heart, a leaf's veins, a bud's calyx, a frond's stem, an obj at its axis or "
          "what of it wears no picture. "
          "Needs shape other than picture");
  v.number("width", o.width, {.min = 0.02, .max = 3}, "Width as a share of the length");
  v.number("widest", o.widest, {.min = 0.05, .max = 0.95},
           "Where along it a leaf or petal is widest, 0 foot to 1 tip; without it as is usual for its shape");
  v.number(
      "round", o.round, kShare,
      "How round a leaf or petal ends: 0 drawn out to a tip, 1 round; without it as is usual for its shape");
  v.integer("detail", o.detail, {.min = 1, .max = 3},
            "How fine leaves and petals are: 10, 52 or 126 triangles each");
  v.angle(
      "fold", o.fold, {.min = -80, .max = 80},
      "Angle by which a leaf is folded along its midrib, or a frond's leaflets are raised above the flat");
  v.angle("bend", o.bend, {.min = -180, .max = 180},
          "Angle by which a leaf, petal, sprig or frond is bent down from foot to tip");
  v.number("wave", o.wave, {.min = 0, .max = 2}, "How much the rim is waved");
  v.integer("petals", o.petals, {.min = 1, .max = 200}, "Number of petals. Needs \"shape\": \"flower\"");
  v.integer(
      "leaflets", o.leaflets, {.min = 0, .max = 400},
      "Number of leaves of a sprig, pairs of leaflets of a frond, or leaflets for each one that a grammar "
      "draws; 0 is as usual for the shape");
  v.integer("lobes", o.lobes, {.min = 0, .max = 40},
            "Number of lobes on either side of a frond's leaflets, as a fern has them; 0 leaves them whole");
  v.angle("droop", o.droop, {.min = -90, .max = 180},
          "Angle by which leaflets of a frond or grammar hang from foot to tip");
  v.integer("variants", o.variants, {.min = 1, .max = 12},
            "Number of different shapes of a sprig, frond or grammar, or of a picture that curls");
  v.angle("open", o.open, {.min = 0, .max = 150},
          "Angle between petals and the heading of the flower or bud");
  v.number("heart", o.heart, kShare, "Radius of a flower's heart, as a share of its size");
  v.number("size_variation", o.size_variation, {.min = 0, .max = 0.9},
           "Random change of the size, as a share of it");
  v.angle("turn_variation", o.turn_variation, {.min = 0, .max = 180},
          "Random tilt of each organ, either way");
  v.object("picture", o.picture,
           "The leaf's outline, colours and mesh; size and variations are those above. Needs \"shape\": "
           "\"picture\"");
  v.object("grammar", o.grammar,
           "The rules that draw it: each branch of one segment is a leaflet, each outline a blade, all else "
           "its stem, whose longest way becomes size. Needs \"shape\": \"grammar\"");
  v.object(
      "diagram", o.diagram,
      "The flower's whorls, whose lengths are shares of size, or the list of them alone. In the grammar a "
      "second "
      "parameter, or a fourth, is its stage: 0 a bud, 1 open, as without it, 2 withered. Needs \"shape\": "
      "\"diagram\"");
  v.object("inflorescence", o.inflorescence,
           "How flowers are borne, on an axis whose length is size; in umbels, corymbs and heads it is the "
           "stalk. In the grammar a "
           "second parameter is its stage: 0 all in bud, 1 as stages says, as without it, 2 all gone by. "
           "Needs \"shape\": "
           "\"inflorescence\"");
  v.object("luster", o.luster, "How it takes light; without it as is usual for its shape");
  v.number("dew", o.dew, {.min = 0, .max = 60}, "Drops of dew on a square centimetre of its upper side");
  v.aspect(Aspect::shape, "symbol", "size", "size_variation", "turn_variation", "diagram", "inflorescence");
}

void describe(Properties& v, PlantGrammar& g) {
  describe_grammar(
      v, g,
      [&](const NamedFile& file) {
        return grammar_kind(file.path.string(), file.text) == GrammarKind::cpfg ? load_cpfg(file, g)
                                                                                : load_grammar(file, g);
      },
      "A grammar of LParser, Houdini or Fractint or a skeleton as SWC, named as seen from this file's "
      "folder, where what else is given here counts in place of what stands there; or a model of cpfg (.l), "
      "which takes only steps, limits and vary from here");
  v.boolean("vary", g.vary,
            "Whether each plant of a model of cpfg has chances of its own; without it all are the one plant "
            "that cpfg grows");
}

void describe(Properties& v, PlantParams& p) {
  v.object("grammar", p.grammar, "The rules that it grows by");
  if (v.purpose() == Purpose::reading) use_model_colors(p);
  v.required("grammar");
  v.number("height", p.height, metres(0, 1000),
           "Height that the whole is scaled to; 0 leaves it as the turtle draws it");
  v.choice("stand", p.origin, kPlantOrigins, "Which point of it stands at its place");
  v.integer("smoothing", p.smoothing, {.min = 1, .max = 16},
            "Number of nodes that each segment is rounded with; 1 leaves straight lines");
  v.object("thickness", p.thickness, "Thickness of the branches");
  v.object("bark", p.bark, "The surface of the branches");
  v.list("organs", p.organs, "What stands at symbols of the grammar: leaves, flowers, meshes");
  v.object("blades", p.blades, "What the turtle's filled outlines are made of");
  v.object("season", p.season, "The course of the year for its leaves; without it they stay as they are");
  v.object("wave", p.wave, "Swaying in the wind");
  v.object("food", p.food, "What its branches bend toward");
  v.object("growth", p.growth, "When it grows in the film");
  v.boolean("by_steps", p.by_steps,
            "Whether growth runs through the derivation steps instead of along the finished branches");
  if (asks(p.grammar)) v.aspect(Aspect::shape, "food", "growth");
  if (v.purpose() == Purpose::reading) use_model_surfaces(p);
}

namespace {

/// Adds what a grammar hangs on its branches: as counted where it is small, and on a smaller one otherwise.
void count_organs(const PlantParams& params, Seed seed, SizeEstimate& plant) {
  Result<Grammar> grammar = plant_grammar(params);
  if (!grammar) return;
  int steps = std::max(plant.word.small_steps, std::min(1, grammar->text.steps));
  std::vector<std::string> names;
  for (const OrganParams& organ : params.organs) names.push_back(organ.symbol);
  Limits limits{2'000'000, std::size_t{64} << 20};
  Result<Figure> figure = figure_of(*grammar, steps, seed, limits, names, params.by_steps);
  if (!figure) return;
  auto segments = static_cast<double>(figure->skeleton.size());
  std::vector<bool> goes_on(figure->skeleton.size());
  for (std::int32_t below : figure->skeleton.parent)
    if (below != Skeleton::kRoot) goes_on[static_cast<std::size_t>(below)] = true;
  auto tips = static_cast<double>(std::count(goes_on.begin(), goes_on.end(), false));
  plant.chains = tips / std::max(1.0, segments * params.smoothing);
  double scale = 1;
  if (steps == grammar->text.steps)
    plant.nodes = segments * params.smoothing;
  else
    scale = std::max(1.0, plant.word.segments / std::max(segments, 1.0));
  std::vector<Prototype> prototypes = organ_prototypes(params);
  std::vector<bool> used(prototypes.size());
  std::size_t bare = figure->skeleton.size();
  if (!expand_inflorescences(*figure, params, prototypes, seed).empty()) return;  // growing it says so
  plant.nodes += scale * static_cast<double>((figure->skeleton.size() - bare) *
                                             static_cast<std::size_t>(params.smoothing));
  for (const Site& site : figure->sites) {
    Variants kinds = variants_of(params, site.name);
    if (kinds.first < 0) continue;
    for (int which : prototypes_at(params, kinds, site.stage)) {
      plant.organs += scale;
      plant.parts += scale * static_cast<double>(prototypes[static_cast<std::size_t>(which)].parts.size());
      for (int k = 0; k < (kinds.pieces > 0 ? 1 : kinds.count); ++k)
        used[static_cast<std::size_t>(which + k)] = true;
    }
  }
  for (const Outline& outline : figure->outlines)
    plant.corners += scale * static_cast<double>(outline.points.size());
  for (std::size_t p = 0; p < prototypes.size(); ++p)
    for (const OrganPart& part : prototypes[p].parts)
      if (used[p]) plant.shapes += static_cast<double>(part.surface.triangle.size());
}

Result<SizeEstimate> word_size(const PlantParams& params, Seed seed) {
  return estimate_word(plant_grammar(params), seed, params.smoothing);
}

class PlantGrower final : public Described<PlantParams, LoneGrower> {
 public:
  static constexpr std::string_view kLeading[] = {
      "height",    "grammar/steps", "grammar/angle",  "grammar/angle_jitter", "grammar/length_jitter",
      "stand",     "smoothing",     "thickness/from", "thickness/radius",     "thickness/exponent",
      "bark/kind", "bark/colors",   "organs"};

  /// What asks grows among what stands; whose places are given stands where they say.
  GrowerTraits traits() const override {
    const GrammarText& text = params.grammar;
    bool placed = !text.guide.empty() || text.axiom.find("@M") != std::string::npos;
    return {.stage = asks(text) ? GrowthStage::in_space : GrowthStage::free,
            .branches = true,
            .rebuilt = params.by_steps || params.season ? Rebuilt::always : Rebuilt::never,
            .tallest = params.height,
            .sunk = placed ? 0.0f : 1.0f};
  }
  Review review() const override {
    std::vector<std::string> symbols;
    for (const OrganParams& organ : params.organs) symbols.push_back(organ.symbol);
    if (Errors errors = season_faults(params.season, symbols); !errors.empty()) return {errors};
    if (params.grammar.cpfg) return {cpfg_faults(params)};
    if (params.grammar.vary)
      return {{{"/grammar/vary",
                "is for models of cpfg (.l); the chances of other grammars vary by themselves"}}};
    Result<Grammar> grammar = plant_grammar(params);
    if (!grammar) return {pointed(params.grammar, grammar.errors())};
    for (std::size_t i = 0; i < params.organs.size(); ++i) {
      const OrganParams& organ = params.organs[i];
      std::string place = fmt::format("/organs/{}", i), pointer = place + "/picture";
      if (organ.picture.has_value() != (organ.shape == OrganShape::picture))
        return {{{pointer, organ.picture ? "needs \"shape\": \"picture\""
                                         : "is missing; the shape \"picture\" needs it"}}};
      if (organ.grammar.has_value() != (organ.shape == OrganShape::grammar))
        return {{{place + "/grammar", organ.grammar ? "needs \"shape\": \"grammar\""
                                                    : "is missing; the shape \"grammar\" needs it"}}};
      if (Errors errors = organ_faults(organ); !errors.empty()) {
        errors = pointed(*organ.grammar, std::move(errors));
        for (Error& error : errors) error.where = place + error.where;
        return {errors};
      }
      if (Errors errors = flower_faults(params.organs, i); !errors.empty()) {
        for (Error& error : errors) error.where = place + error.where;
        return {errors};
      }
      if (Errors errors = check_pictures({}, organ.picture, (pointer + "/pixels").c_str()); !errors.empty())
        return {errors};
    }
    constexpr std::size_t kMostPrototypes = 60000;  // a number of 16 bits, with room for those of seasons
    std::size_t prototypes = 0;
    for (const OrganParams& organ : params.organs)
      prototypes += organ.diagram
                        ? static_cast<std::size_t>(piece_count(*organ.diagram) * stage_count(*organ.diagram))
                        : 64;
    if (prototypes > kMostPrototypes)
      return {{{"/organs", fmt::format("these have {} pieces at all their stages; expected at most {}",
                                       prototypes, kMostPrototypes)}}};
    if (Errors errors = check_asking(*grammar, params.height); !errors.empty()) return {errors};
    if (grammar->asks && params.by_steps)
      return {{{"/by_steps", "found true, but the grammar asks ?E, which is answered once; expected false"}}};
    Errors warnings = pointed(params.grammar, grammar->warnings);
    for (std::size_t i = 0; i < params.organs.size(); ++i)
      if (!params.organs[i].mesh_note.empty())
        warnings.push_back({fmt::format("/organs/{}/file", i), params.organs[i].mesh_note});
    return {pointed(params.grammar, size_faults(*grammar)), std::move(warnings)};
  }
  Result<SizeEstimate> estimate_size(Seed seed) const override {
    if (params.grammar.cpfg) return cpfg_size(params);
    Result<SizeEstimate> plant = word_size(params, seed);
    if (plant) count_organs(params, seed, *plant);
    return plant;
  }
  std::shared_ptr<const Grower> coarse(double share) const override {
    if (params.grammar.cpfg) return nullptr;
    constexpr auto steps = [](PlantParams& p) -> int& { return p.grammar.steps; };
    return fewer_steps<PlantGrower, PlantParams>(*this, share, steps, word_size);
  }
  Appearance appearance() const override {
    Appearance appearance;
    appearance.look.branches = {.bark = params.bark};
    appearance.look.blades = params.blades;
    for (const OrganParams& organ : params.organs) {
      std::ranges::move(organ_mesh_drawings(organ), std::back_inserter(appearance.look.pictures));
      if (organ.picture)
        appearance.look.organs.push_back(params.season ? with_seasons(*organ.picture, *params.season)
                                                       : *organ.picture);
    }
    set_season(appearance, params.season);
    appearance.motion = {params.growth, params.wave, params.food, 1};
    appearance.variation = params.bark.variation;
    return appearance;
  }
  std::optional<Result<Grammar>> grammar() const override {
    if (params.grammar.cpfg) return std::nullopt;
    return plant_grammar(params);
  }
  Result<Model> grow_alone(Seed seed) const override { return grow_plant(params, seed); }
  Result<Model> grow_standing(const World& world, const Planting& planting, const Placement& placement,
                              Seed seed) const override {
    if (!asks(params.grammar)) return grow_plant(params, seed);
    Surroundings around(world, planting.claim, placement);
    return grow_plant(params, seed, 1, environment_of(around, params.food, params.growth));
  }
  /// By steps it grows anew for each frame.
  std::function<Result<Model>(double)> develop(const Motion& motion, Seed seed) const override {
    if (!params.by_steps) return {};
    return [params = params, growth = motion.growth, seed](double time) {
      double share = std::min(growth_front(growth, time) / (1 + growth.ripen), 1.0);
      return grow_plant(params, seed, share);
    };
  }
};

}  // namespace

Kind<Organism> plant_kind() {
  return make_grower<PlantGrower>("plant", "Anything that an L-system draws: herbs, trees, curves");
}

}  // namespace frond
