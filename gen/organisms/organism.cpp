#include "organisms/organism.h"

#include <algorithm>
#include <cmath>

#include "grammar/review.h"
#include "organisms/picture_bounds.h"

namespace frond {

namespace {

struct Grow {
  Seed seed;
  Result<Model> operator()(const CoralParams& params) const {
    Result<Skeleton> skeleton = grow_coral(params, seed);
    if (!skeleton) return skeleton.errors();
    Model model;
    model.skeleton = std::move(*skeleton);
    return model;
  }
  Result<Model> operator()(const RockParams& params) const { return build_rock(params, seed); }
  Result<Model> operator()(const PebblesParams& params) const { return build_pebbles(params, seed); }
  Result<Model> operator()(const PlantParams& params) const { return grow_plant(params, seed); }
  Result<Model> operator()(const WallParams& params) const { return build_wall_model(params, seed); }
  Result<Model> operator()(const ColumnParams& params) const { return build_column_model(params); }
  Result<Model> operator()(const MeshParams& params) const { return build_mesh_model(params); }
  Result<Model> operator()(const BridgeParams& params) const { return grow_bridge(params, seed); }
  Result<Model> operator()(const VaseParams& params) const { return grow_vase(params, seed); }
  Result<Model> operator()(const WeberPennParams& params) const { return grow_weber_penn_tree(params, seed); }
  Result<Model> operator()(const ColonizedParams& params) const { return grow_colonized_tree(params, seed); }
  Result<Model> operator()(const TreeParams& params) const { return grow_tree(params, seed); }
  Result<Model> operator()(const IvyParams&) const { return Error{"", "ivy grows on other bodies"}; }
};

/// Why a derivation is sure not to come to its end. What is only extrapolated is tried when it grows.
Errors foreseen_trouble(const Grammar& grammar) {
  const GrammarText& text = grammar.text;
  Forecast word = forecast(grammar, text.steps, Seed{1}, text.limits);
  bool guess = word.kind == Forecast::Kind::extrapolated && word.trouble.empty();
  return guess ? Errors{} : refuse(word, text.limits);
}

/// What a grammar's word and skeleton will be.
Result<Foresight> foresee_word(const Result<Grammar>& grammar, Seed seed, int smoothing) {
  if (!grammar) return grammar.errors();
  const GrammarText& text = grammar->text;
  Forecast word = forecast(*grammar, text.steps, seed, text.limits);
  if (Errors errors = refuse(word, text.limits); !errors.empty()) return placed(errors, text);
  return Foresight{word, 1 + word.segments * smoothing};
}

struct Check {
  Errors operator()(const CoralParams& params) const {
    Result<Grammar> grammar = coral_grammar(params);
    return grammar ? foreseen_trouble(*grammar) : grammar.errors();
  }
  Errors operator()(const RockParams& params) const { return check_rock(params.shape); }
  Errors operator()(const PebblesParams& params) const { return check_pebbles(params); }
  Errors operator()(const PlantParams& params) const {
    Result<Grammar> grammar = plant_grammar(params);
    return grammar ? foreseen_trouble(*grammar) : grammar.errors();
  }
  Errors operator()(const WallParams&) const { return {}; }
  Errors operator()(const ColumnParams&) const { return {}; }
  Errors operator()(const MeshParams&) const { return {}; }
  Errors operator()(const BridgeParams&) const { return {}; }
  Errors operator()(const VaseParams& params) const {
    Result<VesselProfile> profile = vessel_profile(params.shape);
    return profile ? Errors{} : profile.errors();
  }
  Errors operator()(const WeberPennParams& params) const {
    if (foresee_nodes(params.tree) < 8e6) return check_pictures(params.dress);
    return {{"", "the tree would have more than 4000000 nodes; fewer branches, splits or segments"}};
  }
  Errors operator()(const ColonizedParams& params) const {
    Errors errors = check_colonized(params);
    return errors.empty() ? check_pictures(params.dress) : errors;
  }
  Errors operator()(const TreeParams& params) const { return check_pictures(params); }
  Errors operator()(const IvyParams&) const { return {}; }
};

/// As large as a tree must be for its later growth to be told from it.
constexpr double kToldBy = 20'000;

/// Nodes of a tree by light. What light leaves of it is not known before it has grown; but once its crown is
/// closed it grows about as much each year, and less when it is as tall as it will be. So it is grown
/// until then, in two or three goes, and the years that are left are reckoned.
double foresee_tree(const TreeParams& params, Seed seed) {
  TreeParams young = params;
  double before = 0, nodes = 0, tall = 0;
  int since = 0;
  young.years = std::min(params.years, 10);
  for (;;) {
    Skeleton s = grow_tree(young, seed).skeleton;
    before = nodes;
    nodes = static_cast<double>(s.size());
    for (const Vec3& p : s.position) tall = std::max<double>(tall, p.y);
    if (young.years == params.years || nodes > kToldBy) break;
    since = young.years;
    // A crown that is not closed yet grows by a third to a half in a year.
    int more = std::clamp(static_cast<int>(std::log(1.2 * kToldBy / nodes) / std::log(1.35)), 2, 8);
    young.years = std::min(params.years, young.years + more);
  }
  if (young.years == params.years) return nodes;
  double added = (nodes - before) / std::max(1, young.years - since), left = params.years - young.years;
  double rising = std::clamp(young.years * (params.species.height / std::max(tall, 0.1) - 1), 0.0, left);
  // It added less while its crown was still closing.
  return nodes + added * (1.25 * rising + 0.75 * (left - rising));
}

struct Foresee {
  Seed seed;
  Result<Foresight> operator()(const BridgeParams&) const { return Foresight{}; }
  Result<Foresight> operator()(const VaseParams&) const { return Foresight{}; }
  Result<Foresight> operator()(const RockParams&) const { return Foresight{}; }
  Result<Foresight> operator()(const PebblesParams&) const { return Foresight{}; }
  Result<Foresight> operator()(const TreeParams& params) const {
    Foresight tree;
    tree.nodes = foresee_tree(params, seed);
    tree.word.modules = tree.word.segments = tree.nodes;
    return tree;
  }
  Result<Foresight> operator()(const PlantParams& params) const {
    return foresee_word(plant_grammar(params), seed, params.smoothing);
  }
  Result<Foresight> operator()(const CoralParams& params) const {
    return foresee_word(coral_grammar(params), seed, params.smoothing);
  }
  // Bodies have no branches.
  Result<Foresight> operator()(const WallParams&) const { return Foresight{}; }
  Result<Foresight> operator()(const ColumnParams&) const { return Foresight{}; }
  Result<Foresight> operator()(const MeshParams&) const { return Foresight{}; }
  Result<Foresight> operator()(const WeberPennParams& params) const {
    return Foresight{{}, foresee_nodes(params.tree)};
  }
  Result<Foresight> operator()(const ColonizedParams& params) const {
    // Of the points no more count than have room beside each other, and many are taken by the way.
    const Colonization& how = params.growth_into;
    const EnvelopeParams& e = params.envelope;
    double room = e.width * e.height * (e.depth > 0 ? e.depth : e.width) / std::pow(how.kill, 3);
    double nodes = std::min({0.8 * how.attractors, 0.8 * room, static_cast<double>(how.most_nodes)});
    return Foresight{{}, (nodes + e.base / how.step) * params.smoothing};
  }
  // How far ivy comes shows only on its host: here it always finds room.
  Result<Foresight> operator()(const IvyParams& params) const {
    const Crawl& crawl = params.crawl;
    double length = std::min(crawl.max_age * crawl.speed, crawl.max_length);
    double steps = length / crawl.speed, branches = crawl.branch_depth > 0 ? length / crawl.branch_every : 0;
    return Foresight{{}, std::min(steps * (1 + 1.5 * branches), static_cast<double>(crawl.most_nodes))};
  }
};

}  // namespace

Result<Model> grow(const Organism& organism, Seed seed) { return std::visit(Grow{seed}, organism.body); }

Result<Foresight> foresee(const Organism& organism, Seed seed) {
  return std::visit(Foresee{seed}, organism.body);
}

std::vector<Drawing> drawings(const Organism& organism) {
  if (const auto* tree = std::get_if<WeberPennParams>(&organism.body))
    return dress_drawings(tree->dress, tree->tree.leaves != 0);
  if (const auto* tree = std::get_if<ColonizedParams>(&organism.body))
    return dress_drawings(tree->dress, tree->leaf_reach > 0);
  if (const auto* tree = std::get_if<TreeParams>(&organism.body)) return tree_drawings(*tree);
  return {};
}

Errors check(const Organism& organism) { return std::visit(Check{}, organism.body); }

Errors doubts(const Organism& organism) {
  Result<Grammar> grammar = Error{};
  if (const auto* coral = std::get_if<CoralParams>(&organism.body)) grammar = coral_grammar(*coral);
  if (const auto* plant = std::get_if<PlantParams>(&organism.body)) grammar = plant_grammar(*plant);
  return grammar ? grammar->warnings : Errors{};
}

}  // namespace frond
