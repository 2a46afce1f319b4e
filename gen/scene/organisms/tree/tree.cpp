#include "organisms/tree/tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "grove/age.h"
#include "grove/bodies.h"
#include "grove/edit_tree.h"
#include "organisms/tree/knots.h"
#include "organisms/tree/topple.h"

namespace frond {

CutFace cut_of(const Standing& now, const GrownTree& tree) {
  assert(now.size() > 0);
  CutFace cut{now.tip[0], 0};
  if (!tree.uprooting.felled) return cut;
  float top = 0;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (tree.order[now.source[i]] == 0) top = std::max(top, now.tip[i].y - now.tip[0].y);
  cut.height = std::min(kStump, top / 2);
  for (std::size_t i = 1; i < now.size(); ++i) {
    float from = now.foot[i].y - now.tip[0].y, to = now.tip[i].y - now.tip[0].y;
    if (tree.order[now.source[i]] > 0 || from > cut.height || to <= cut.height) continue;
    cut.at = glm::mix(now.foot[i], now.tip[i], (cut.height - from) / (to - from));
    break;
  }
  return cut;
}

namespace {

constexpr double kSummer = 0.5;                      // of a cycle: when it is looked at in the end
constexpr float kSmallestSprig = 0.04f;              // share of its size
constexpr double kOpenYears = 4, kClosedYears = 20;  // cycles until a wound begins to close, and has closed
constexpr float kFlareHeight = 4;                    // radii of the stem
constexpr int kRootNodes = 5;
constexpr int kPlateRoots = 36;

/// The foot of the stem: wider toward the ground.
float flared(const TreeParams& params, float base, float height) {
  float t = std::clamp(1 - height / std::max(kFlareHeight * base, 1e-4f), 0.0f, 1.0f);
  return 1 + static_cast<float>(params.flare) * t * t * t;
}

/// Branches as a skeleton; gives the node of each internode.
std::vector<std::int32_t> add_branches(Model& model, const Standing& now, const GrownTree& tree,
                                       const TreeParams& params) {
  Skeleton& s = model.skeleton;
  std::vector<std::int32_t> node(now.size());
  s.reserve(now.size() + 64);
  float base = now.size() > 1 ? now.radius[1] : 0.001f, ground = now.size() > 0 ? now.tip[0].y : 0;
  const CutFace cut = now.size() > 0 ? cut_of(now, tree) : CutFace{};
  for (std::size_t i = 0; i < now.size(); ++i) {
    std::uint16_t order = tree.order[now.source[i]];
    float radius = now.radius[i];
    if (i > 0 && order == 0 && now.tip[i].y - ground <= cut.height) {
      node[i] = 0;  // it is part of the stump
      continue;
    }
    if (i == 0) radius = base;
    Vec3 tip = i == 0 ? cut.at : now.tip[i];
    if (order == 0) radius *= flared(params, base, tip.y - ground);
    std::int32_t below = now.parent[i];
    if (below != GrownTree::kRoot) {
      bool broke = glm::distance(now.tip[below], now.foot[i]) > 1e-4f;
      below = broke ? s.add(now.foot[i], radius, Skeleton::kRoot, order) : node[below];
    }
    node[i] = s.add(tip, radius, below, order);
    std::size_t source = now.source[i] == 0 && tree.size() > 1 ? 1 : now.source[i];
    model.girth.resize(s.size(), tree.radius[source]);
  }
  return node;
}

/// What stays of a tree that is felled, below the cut; gives the node at its foot.
std::int32_t add_stump(Skeleton& s, const Standing& now, const TreeParams& params) {
  const float base = now.radius[1];
  const Vec3 foot = now.tip[0], face = s.position[0];
  std::int32_t below = s.add(foot, base * flared(params, base, 0), Skeleton::kRoot, 0), lowest = below;
  for (int k = 1; k <= kRootNodes; ++k) {
    Vec3 at = glm::mix(foot, face, static_cast<float>(k) / kRootNodes);
    below = s.add(at, base * flared(params, base, at.y - foot.y), below, 0);
  }
  return lowest;
}

/// Roots that run out from the foot of the stem and into the ground.
void add_roots(Skeleton& s, const TreeParams& params, std::int32_t at, Seed seed) {
  // Radii of the stem, by eye: how far out and how high they begin, and how deep they end.
  constexpr float kRootFrom = 0.5f, kRootHigh = 0.55f, kRootDeep = 0.36f;
  if (s.size() < 2 || params.roots == 0) return;
  float base = s.radius[static_cast<std::size_t>(at)];
  Vec3 foot = s.position[static_cast<std::size_t>(at)];
  for (int k = 0; k < params.roots; ++k) {
    Seed own = seed.child(static_cast<std::uint64_t>(k));
    double turn = 2 * kPi * (k + own.child(0).range(-0.3, 0.3)) / params.roots;
    Vec3 out(static_cast<float>(std::cos(turn)), 0, static_cast<float>(std::sin(turn)));
    Vec3 across(-out.z, 0, out.x);
    float length = base * static_cast<float>(own.child(1).range(0.9, 1.7));
    float thick = base * static_cast<float>(own.child(2).range(0.20, 0.32));
    auto bend = static_cast<float>(own.child(3).range(-0.4, 0.4));
    std::int32_t below = at;
    for (int i = 1; i <= kRootNodes; ++i) {
      float t = static_cast<float>(i) / kRootNodes, far = base * kRootFrom + length * t;
      float high = base * (kRootHigh * (1 - t) * (1 - t) - kRootDeep * t);
      below = s.add(foot + out * far + across * (bend * far * t) + Vec3(0, high, 0),
                    thick * (1.15f - 0.75f * t), below, static_cast<std::uint16_t>(1));
    }
  }
}

/// The roots within the ground that an uprooted tree lifts: level ones to the edge of the plate, and sinkers.
void add_root_plate(Skeleton& s, Seed seed) {
  if (s.size() < 2) return;
  const float base = s.radius[0], reach = kRootPlate * s.radius[1];
  const Vec3 foot = s.position[0];
  for (int k = 0; k < kPlateRoots; ++k) {
    Seed own = seed.child(static_cast<std::uint64_t>(k));
    double turn = 2 * kPi * (k + own.child(0).range(-0.4, 0.4)) / kPlateRoots;
    Vec3 out(static_cast<float>(std::cos(turn)), 0, static_cast<float>(std::sin(turn)));
    auto far = reach * static_cast<float>(own.child(1).range(0.55, 0.98));
    const bool sinker = k % 3 == 0;
    const double down = sinker ? own.child(2).range(0.3, 0.5) : own.child(2).range(0.04, 0.2);
    auto deep = reach * static_cast<float>(down);
    auto bend = static_cast<float>(own.child(3).range(-0.5, 0.5));
    float thick = base * static_cast<float>(own.child(4).range(0.08, 0.2));
    std::int32_t below = 0;
    for (int i = 1; i <= kRootNodes; ++i) {
      float t = static_cast<float>(i) / kRootNodes;
      Vec3 aside = Vec3(-out.z, 0, out.x) * (bend * far * t * (1 - t));
      below = s.add(foot + out * (far * t) + aside - Vec3(0, 1.2f * thick + deep * t * t, 0),
                    thick * (1.1f - 0.9f * t), below, static_cast<std::uint16_t>(1));
    }
  }
}

/// Puts the nodes in the order of their branches; gives the new place of each.
std::vector<std::int32_t> order_model(Model& model) {
  for (std::size_t i = model.girth.size(); i < model.skeleton.size(); ++i)
    model.girth.push_back(model.skeleton.radius[i]);
  std::vector<std::int32_t> order = order_branches(model.skeleton);
  std::vector<float> girth(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) girth[static_cast<std::size_t>(order[i])] = model.girth[i];
  model.girth = std::move(girth);
  return order;
}

/// Tells the axes of the nodes of internodes, and adds the faces of what was sawn off by that year.
void add_axes(Model& model, const Standing& now, const GrownTree& tree, const std::vector<std::int32_t>& node,
              double year) {
  const Skeleton& s = model.skeleton;
  model.axes.assign(s.size(), {-1, 0});
  std::vector<std::int32_t> at(tree.cuts.empty() ? 0 : tree.size(), GrownTree::kRoot);
  for (std::size_t i = 0; i < now.size(); ++i) {
    model.axes[node[i]] = tree.axes[now.source[i]];
    if (!at.empty()) at[now.source[i]] = node[i];
  }
  for (const SawnEnd& cut : tree.cuts) {
    const std::int32_t end = at[cut.on];
    if (end < 0 || cut.time > year || s.parent[end] == Skeleton::kRoot) continue;
    const double old = cut.time == SawnEnd::kFresh ? 0 : year - cut.time;
    const auto open = static_cast<float>(1 - smooth_step(kOpenYears, kClosedYears, old));
    add_cut_face(model, end, s.position[end] - s.position[s.parent[end]], cut.on, open);
  }
}

/// One, or that of sprigs at the ends of branches and that of those along them.
std::vector<Prototype> sprig_prototypes(const TreeParams& params) {
  const Foliage& leaves = params.leaves;
  if (leaves.picture) return leaf_prototypes(pictured_leaves(params));
  Prototype made{"sprig", {{Tissue::leaf, sprig_surface(leaves.sprig)}}, leaves.colors, leaves.second};
  if (params.season) add_seasons(made, *params.season);
  return {made};
}

/// A sprig's frame: along it, and its upper side to the sky.
Quat sprig_turn(Vec3 heading, Vec3 side, const Foliage& leaves, bool leads, Seed seed) {
  constexpr float kLeadsAside = 0.15f;  // radians between a branch and the sprig at its end
  constexpr float kScatter = 0.18f;
  constexpr double kSkyScatter = 0.45;
  float open = leads ? kLeadsAside : static_cast<float>(leaves.spread * seed.child(1).range(0.7, 1.25));
  Vec3 along = heading * std::cos(open) + side * std::sin(open);
  auto hang = static_cast<float>(leaves.hang);
  along = glm::normalize(along * (1 - hang) + Vec3(0, -1, 0) * hang +
                         kScatter * Vec3(static_cast<float>(seed.child(2).range(-1, 1)),
                                         static_cast<float>(seed.child(3).range(-1, 1)),
                                         static_cast<float>(seed.child(4).range(-1, 1))));
  Vec3 sky(static_cast<float>(seed.child(5).range(-kSkyScatter, kSkyScatter)), 1,
           static_cast<float>(seed.child(6).range(-kSkyScatter, kSkyScatter)));
  Vec3 up = sky - along * glm::dot(sky, along);
  if (glm::length(up) < 0.2f) up = side - along * glm::dot(side, along);
  if (glm::length(up) < 1e-3f) up = glm::cross(along, Vec3(1, 0, 0.3f));
  up = glm::normalize(up);
  return glm::normalize(glm::quat_cast(glm::mat3(glm::cross(along, up), along, up)));
}

void add_sprigs(Model& model, const Standing& now, const GrownTree& tree,
                const std::vector<std::int32_t>& node, const TreeParams& params, Seed seed) {
  const Foliage& leaves = params.leaves;
  model.prototypes = sprig_prototypes(params);
  bool both = model.prototypes.size() > 1;
  if (params.season) add_seasonal(model.prototypes, *params.season);
  std::size_t colors = leaves.picture ? leaves.picture->colors.size() : leaves.colors.size();
  Organs& o = model.organs;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now.leaves[i] < kSmallestSprig || now.parent[i] == GrownTree::kRoot) continue;
    std::uint32_t source = now.source[i];
    Vec3 offset = now.tip[i] - now.foot[i];
    float length = glm::length(offset);
    Vec3 heading = length > 1e-6f ? offset / length : Vec3(0, 1, 0);
    for (bool leads : {false, true}) {
      if (leads && !tree.leads[source]) continue;
      Seed own = seed.child(2 * std::uint64_t{source} + (leads ? 1 : 0));
      float size = now.leaves[i] *
                   static_cast<float>(leaves.size * (1 + leaves.size_variation * own.child(0).range(-1, 1)));
      o.prototype.push_back(both && !leads ? 1 : 0);
      o.position.push_back(now.tip[i]);
      o.turn.push_back(sprig_turn(heading, now.side[i], leaves, leads, own));
      o.scale.push_back(Vec3(std::max(size, 1e-4f)));
      o.node.push_back(node[i]);
      o.birth.push_back(0);
      o.color.push_back(static_cast<std::int32_t>(own.child(7).bits() % colors));
      o.id.push_back(source);
    }
  }
}

/// The line that the stem of a tree follows, where it stands; empty where it has no guide.
std::vector<Vec3> line_of(const TreeSite& site) {
  Result<GuideAxes> guides = axes_of_guide(site.params->guide);
  std::vector<GuideAxis> axes = guides ? axes_of(*guides) : std::vector<GuideAxis>{};
  std::vector<Vec3> line;
  if (!axes.empty() && axes[0].at.size() > 1)
    for (const Vec3& at : axes[0].at) line.push_back(site.foot + site.lean * at);
  return line;
}

/// The cuts of a tree in years of its life, as the grove counts cycles since it was planted.
std::vector<YearCut> year_cuts(const TreeSite& site) {
  std::vector<YearCut> cuts;
  for (const Edit& edit : site.edits)
    if (edit.dated())
      cuts.push_back({std::max(0, static_cast<int>(cycle_at_age(site.params->species, *edit.cut)) - 1),
                      edit.at, edit.number});
  return cuts;
}

/// The laws of a grove, which its first tree says.
GroveOptions grove_options(const TreeParams& first, bool history, Seed weather,
                           std::span<const Surface> bodies) {
  GroveOptions options;
  options.seed = weather;
  options.history = history;
  options.most_internodes = first.budget.most();
  options.light = first.light;
  options.wind = first.wind;
  options.snow = first.snow;
  for (const Surface& body : bodies) {
    std::vector<Shade> shades = shades_of_body(body, options.light);
    options.bodies.insert(options.bodies.end(), shades.begin(), shades.end());
  }
  return options;
}

/// Notes cuts in years that trees do not live to see.
void note_late_cuts(const std::vector<Seedling>& seedlings, Grove& grove) {
  for (std::size_t i = 0; i < seedlings.size(); ++i)
    for (const YearCut& cut : seedlings[i].cuts)
      if (cut.year >= grove.cycles)
        grove.trees[i].notes.push_back(
            fmt::format("/edits/{}/cut: is after the last year of the tree", cut.number));
}

/// Shapes the branches of a grown tree by the place where they leave their parent, in all years of its life.
void shape_tree(GrownTree& t, const BranchesAlong& by) {
  if (by.even()) return;
  const ShapedAlong to = shape_along(t.parent, t.axes, t.tip, t.radius, by);
  t.tip = to.position;
  turn_wood(t, to.turn, to.radius);
}

}  // namespace

LeafLook pictured_leaves(const TreeParams& params) {
  const LeafLook& look = *params.leaves.picture;
  return params.season ? with_seasons(look, *params.season) : look;
}

double cycle_at(const Growth& growth, int cycles, double time) {
  double end = cycles + kSummer;
  if (growth.duration <= 0) return time >= growth.start ? end : 0;
  return end * std::clamp((time - growth.start) / growth.duration, 0.0, 1.0);
}

std::size_t GrowthBudget::most() const {
  constexpr double kInternodesASecond = 3e5;
  if (internodes > 0) return static_cast<std::size_t>(internodes);
  return static_cast<std::size_t>(std::ceil(seconds * kInternodesASecond));
}

int cycles_of(const TreeParams& params) { return growth_cycles(params.species, params.years); }

Grove grow_trees(std::span<const TreeSite> sites, bool history, Seed weather, std::span<const Surface> bodies,
                 const Detour& detour, std::span<const Event> events, std::optional<Vec3> toward) {
  if (sites.empty()) return {};
  std::vector<Seedling> seedlings;
  std::vector<int> ages;
  std::vector<std::vector<YearCut>> own_cuts;
  for (const TreeSite& site : sites) {
    ages.push_back(std::max(1, static_cast<int>(std::lround(cycles_of(*site.params) * site.age))));
    seedlings.push_back({in_cycles(site.params->species), site.foot, site.lean * Vec3(0, 1, 0), site.seed, 0,
                         line_of(site), site.name, year_cuts(site)});
    own_cuts.push_back(seedlings.back().cuts);
  }
  const auto oldest_at = std::ranges::max_element(ages);
  const int oldest = *oldest_at;
  GroveOptions options = grove_options(*sites[0].params, history, weather, bodies);
  options.detour = detour;
  options.dates.toward = toward;
  const Species& first = sites[static_cast<std::size_t>(oldest_at - ages.begin())].params->species;
  for (const Event& event : events)
    options.dates.events.push_back(
        {std::max(0, static_cast<int>(cycle_at_age(first, event.year)) - 1), event});
  for (Grove grove{oldest, {}};;) {
    bool even = true;
    for (std::size_t i = 0; i < seedlings.size(); ++i) {
      // Where a budget makes the oldest younger, the others are younger in proportion.
      double age = std::round(static_cast<double>(ages[i]) * grove.cycles / oldest);
      seedlings[i].planted = grove.cycles - std::max(1, static_cast<int>(age));
      for (std::size_t k = 0; k < own_cuts[i].size(); ++k)
        seedlings[i].cuts[k].year = own_cuts[i][k].year + seedlings[i].planted;
      even = even && seedlings[i].planted == 0;
    }
    options.years = grove.cycles;
    grove.trees = grow_grove(seedlings, options);
    int lived = 0;
    for (const GrownTree& tree : grove.trees) lived = std::max(lived, static_cast<int>(tree.sizes.size()));
    note_late_cuts(seedlings, grove);
    bool whole = std::exchange(grove.cycles, lived) == lived;
    if (!whole && !even) continue;
    for (std::size_t i = 0; i < sites.size(); ++i) shape_tree(grove.trees[i], sites[i].params->along);
    return grove;
  }
}

Model tree_model(const TreeParams& params, const GrownTree& tree, double year, const Filming& filming,
                 Seed seed) {
  Standing now = standing(tree, params.species, year, filming);
  Model model;
  std::vector<std::int32_t> node = add_branches(model, now, tree, params);
  const bool felled = tree.uprooting.felled && now.size() > 1;
  add_roots(model.skeleton, params, felled ? add_stump(model.skeleton, now, params) : 0, seed.child("root"));
  if (tree.uprooting.happens() && !felled) add_root_plate(model.skeleton, seed.child("root plate"));
  std::vector<Knot> knots =
      add_knots(model.skeleton, now, tree, node, params.knots, year, seed.child("knot"));
  std::vector<std::int32_t> order = order_model(model);
  for (std::int32_t& n : node) n = order[static_cast<std::size_t>(n)];
  set_tip_distances(model.skeleton);
  if (params.leaves.size > 0) add_sprigs(model, now, tree, node, params, seed.child("sprig"));
  add_axes(model, now, tree, node, year);
  for (Knot& knot : knots) knot.node = order[static_cast<std::size_t>(knot.node)];
  if (params.knots > 0 && !tree.scars.empty()) add_wounds(model, knots);
  return model;
}

Model grow_tree(const TreeParams& params, Seed seed) {
  TreeSite site{&params, Vec3(0), Quat(1, 0, 0, 0), 1, seed.child("tree")};
  Grove grove = grow_trees({&site, 1}, false, seed.child("weather"));
  return tree_model(params, grove.trees[0], cycle_at({}, grove.cycles, 0), {}, seed.child("look"));
}

double estimate_tree_nodes(const TreeParams& params, Seed seed) {
  constexpr double kToldBy = 60'000;  // nodes: as large as it must be for its later growth to be told from it
  constexpr double kSteepest = 4;  // power, of large trees: the crown widens, and its leaves shade each other
  constexpr double kOpenGrows = 1.35;  // a crown that is not closed yet grows by a third to a half in a cycle
  TreeParams young = params;
  young.species = in_cycles(params.species);
  const int cycles = cycles_of(params);
  double before = 0, nodes = 0;
  int since = 0;
  young.years = std::min(cycles, 10);
  for (;;) {
    before = nodes;
    nodes = static_cast<double>(grow_tree(young, seed).skeleton.size());
    if (young.years == cycles) return nodes;
    if (nodes > kToldBy) break;
    since = young.years;
    int more = std::clamp(static_cast<int>(std::log(1.2 * kToldBy / nodes) / std::log(kOpenGrows)), 2, 8);
    young.years = std::min(cycles, young.years + more);
  }
  double power = since > 0 ? std::log(nodes / before) / std::log(double(young.years) / since) : kSteepest;
  return nodes * std::pow(double(cycles) / young.years, std::clamp(power, 0.0, kSteepest));
}

}  // namespace frond
