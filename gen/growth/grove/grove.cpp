#include "grove/grove.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/bytes.h"
#include "core/parallel.h"
#include "grove/edit_tree.h"
#include "grove/metamers.h"
#include "grove/resource.h"
#include "grove/shed.h"
#include "grove/shoots.h"

namespace frond {

namespace {

constexpr float kBough = 5;            // times as thick as a twig: what leaves a scar where it comes off
constexpr float kBreastHeight = 1.3f;  // metres, at which foresters measure stems
// Bytes of a metamer: of the state, and of what the pass over loads needs besides.
constexpr std::size_t kBytesAMetamer = 2 * sizeof(Vec3) + 2 * sizeof(std::int32_t) + 7 * sizeof(float) + 2 +
                                       sizeof(Shade) + 9 * sizeof(float) + 1;

/// A metamer as it is, or as it was when it fell.
struct Part {
  Vec3 tip, side;
  std::uint32_t serial, parent;  // the foot is its own parent
  float born, died, fell, pipe, light;
  std::uint8_t order;
  bool leads, regrown;
};

Part part_of(const Metamers& m, std::size_t i, float fell) {
  std::size_t p = m.parent[i] == Metamers::kRoot ? i : static_cast<std::size_t>(m.parent[i]);
  bool leads = fell == Metamers::kNever && m.has(i, Metamers::leading);
  return {m.tip[i], m.side[i], m.serial[i], m.serial[p], m.born[i], std::min(m.died[i], fell),
          fell,     m.pipe[i], m.light[i],  m.order[i],  leads,     m.has(i, Metamers::regrown)};
}

/// The pipes of the metamers that stood at the end of a year.
struct YearRings {
  std::vector<std::uint32_t> serial;
  std::vector<float> pipe;
};

struct Tree {
  const Seedling* seedling = nullptr;
  Metamers living;
  std::uint32_t serial = 1;
  std::vector<Part> fallen;
  std::vector<YearRings> rings;
  GrownTree grown;  // but for its internodes; `on` of scars and cuts is a serial as yet
};

void plant(Tree& tree) {
  assert(tree.seedling && tree.living.size() == 0);
  assert(std::abs(glm::length(tree.seedling->up) - 1) < 1e-3f);
  Metamers& m = tree.living;
  m.resize(1);
  const Seedling& s = *tree.seedling;
  m.tip[0] = s.foot;
  Vec3 across = std::abs(s.up.x) < 0.7f ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
  m.side[0] = glm::normalize(glm::cross(s.up, across));
  m.parent[0] = Metamers::kRoot;
  m.serial[0] = 0;
  m.born[0] = static_cast<float>(s.planted);
  m.flags[0] = Metamers::leading;
  m.order[0] = 0;
}

std::vector<Shade> shades_of(const Tree& tree, const LightLaw& law, int year) {
  const Metamers& m = tree.living;
  const Species& s = tree.seedling->species;
  std::vector<Shade> list;
  if (tree.grown.uprooting.happens()) return list;  // what lies on the ground shades nobody
  bool filling = law.fading == Fading::even;
  float leafy = shade_amount(law, s.leaf_area, 0);
  for (std::size_t i = 1; i < m.size(); ++i) {
    bool leaves = bears_leaves(m, s, i, year);
    if (!leaves && !filling) continue;
    Vec3 from = m.tip[m.parent[i]], to = m.tip[i];
    if (filling) {
      float r = pipe_radius(s.wood, m.pipe[i]);
      double volume = kPi * r * r * glm::distance(from, to);
      list.push_back({(from + to) / 2.0f, shade_amount(law, leaves ? s.leaf_area : 0, volume)});
    } else {
      list.push_back({to, leafy});
    }
  }
  return list;
}

void cast_light(LightField& field, const std::vector<Tree>& trees, const GroveOptions& options, int year) {
  std::vector<std::vector<Shade>> parts(trees.size());
  parallel_for(trees.size(), [&](std::size_t i) { parts[i] = shades_of(trees[i], options.light, year); });
  std::vector<Shade> all = options.bodies;
  float floor = trees[0].seedling->foot.y;
  for (const Tree& tree : trees) floor = std::min(floor, tree.seedling->foot.y);
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  Seed jitter = options.seed.child("grid").child(static_cast<std::uint64_t>(year));
  field.cast(all, floor, Vec3(jitter.child(0).unit(), jitter.child(1).unit(), jitter.child(2).unit()));
}

/// What a side branch that falls leaves on what bore it.
void scar(Tree& tree, std::size_t i, float time) {
  const Metamers& m = tree.living;
  auto p = static_cast<std::size_t>(m.parent[i]);
  const Wood& wood = tree.seedling->species.wood;
  float radius = pipe_radius(wood, m.pipe[i]);
  if (!m.has(i, Metamers::side_shoot) || radius < kBough * static_cast<float>(wood.twig_radius)) return;
  tree.grown.scars.push_back(
      {m.serial[p], m.heading(i), radius, pipe_radius(wood, m.pipe[p]), time, m.serial[i]});
}

void drop(Tree& tree, const Falls& falls, bool history) {
  assert(falls.time.size() == tree.living.size());
  assert(falls.time[0] == Metamers::kNever && "the foot never falls");
  Metamers& m = tree.living;
  tree.grown.broken += falls.broken;
  std::vector<std::uint8_t> stay(m.size());
  std::size_t gone = 0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    stay[i] = falls.time[i] == Metamers::kNever;
    if (stay[i]) continue;
    ++gone;
    auto p = static_cast<std::size_t>(m.parent[i]);
    if (falls.time[p] == Metamers::kNever) scar(tree, i, falls.time[i]);
    if (history) tree.fallen.push_back(part_of(m, i, falls.time[i]));
  }
  // A stem that has lost its leader goes on from its buds, the dead nowhere.
  if (gone > 0) m.keep(stay);
}

Size size_of(const Metamers& m, const Wood& wood) {
  Size size;
  size.internodes = m.size() - 1;
  for (std::size_t i = 1; i < m.size(); ++i) {
    float from = m.tip[m.parent[i]].y - m.tip[0].y, to = m.tip[i].y - m.tip[0].y;
    if (!m.has(i, Metamers::dead)) size.height = std::max(size.height, to);
    if (m.order[i] > 0 || from > kBreastHeight || to < kBreastHeight) continue;
    size.breast_diameter = std::max(size.breast_diameter, 2 * pipe_radius(wood, m.pipe[i]));
  }
  return size;
}

/// Moves every tip to where the detour lets it be, by the radius that its internode has now, and what it
/// bears with it: a stem that thickens beside a wall is pushed off it. Of this year's shoots, metamers
/// `first` and after, those of branches that would turn by more than 60 degrees are taken off, and what has
/// no way on.
void bend_aside(Metamers& t, const Wood& wood, const Detour& detour, std::size_t first) {
  constexpr float kMostTurned = 0.5f;  // cosine of the angle that a branch's new shoot bends aside at most
  assert(first <= t.size());
  std::vector<Vec3> shift(t.size(), Vec3(0));
  std::vector<std::uint8_t> stay(t.size(), 1);
  bool all = true;
  for (std::size_t i = 1; i < t.size(); ++i) {
    auto p = static_cast<std::size_t>(t.parent[i]);
    Vec3 from = t.tip[p], to = t.tip[i] + shift[p];
    std::optional<Vec3> way;
    if (stay[p]) way = detour(from, to, pipe_radius(wood, t.pipe[i]) + kBarkGap);
    bool turned =
        way && t.order[i] > 0 &&
        glm::dot(*way - from, to - from) < kMostTurned * glm::length(*way - from) * glm::length(to - from);
    if (i >= first && (!way || turned)) {
      stay[i] = 0;
      all = false;
      continue;
    }
    to = way.value_or(to);
    shift[i] = to - t.tip[i];
    t.tip[i] = to;
  }
  if (!all) t.keep(stay);
}

void live_a_year(Tree& tree, const LightField& field, const GroveOptions& options, const Weather& storm,
                 int year) {
  const Seedling& seedling = *tree.seedling;
  const Species& s = seedling.species;
  if (year < seedling.planted) return;
  if (tree.grown.uprooting.happens())
    return tree.grown.sizes.push_back({0, 0, tree.grown.sizes.back().internodes});
  if (tree.living.size() == 0) plant(tree);
  Metamers& m = tree.living;
  Season season{s, field, seedling.seed, year, seedling.guide};
  assert(m.parent[0] == Metamers::kRoot);
  double age = year - seedling.planted;

  measure_light(m, season, shade_amount(field.law(), s.leaf_area, 0));
  float light = gather_light(m);
  if (die_of_shade(m, s, seedling.seed, year, age) > 0) light = gather_light(m);
  auto resource = static_cast<float>(s.vigour) * light;
  // A seed brings what its first shoot needs.
  if (m.size() == 1) resource = std::max(resource, 3.0f);
  if (s.sharing == Sharing::borchert_honda)
    share_by_forks(m, s, age, resource);
  else
    share_by_priority(m, s, age, resource);
  std::size_t first = grow_shoots(m, season, tree.serial);
  thicken(m);
  sag(m, s.wood, s.leaf_area, first, !seedling.guide.empty());
  if (options.detour) bend_aside(m, s.wood, options.detour, first);

  Strain strain = strain_of(m, s, storm, year);
  brace(m, s.wood, strain);
  Falls falls = find_falls(m, s, strain, seedling.seed, year);
  prune(m, pruned_in(options.dates, year, seedling.name), seedling.seed, year, falls);
  for (std::size_t end : saw(m, seedling.cuts, year, falls, tree.grown.notes))
    tree.grown.cuts.push_back({m.serial[end], static_cast<float>(year + 1)});
  if (falls.stem && tree.grown.stem_broke < 0) tree.grown.stem_broke = year;
  if (options.history) tree.rings.push_back({m.serial, m.pipe});
  tree.grown.bytes = std::max(tree.grown.bytes, m.size() * kBytesAMetamer);
  drop(tree, falls, options.history);
  tree.grown.sizes.push_back(size_of(m, s.wood));
  tree.grown.uprooting = uprooting_of(m, s, storm, year);
  if (tree.grown.uprooting.happens()) die(m, tree.grown.uprooting.time);
}

/// Fells trees as the events of a year say.
void fell(std::vector<Tree>& trees, const GroveOptions& options, int year) {
  if (options.dates.events.empty()) return;
  std::vector<FellingTree> may_fall;
  for (const Tree& tree : trees)
    may_fall.push_back({tree.seedling->name, tree.seedling->seed,
                        tree.living.size() > 1 && !tree.grown.uprooting.happens()});
  std::vector<std::uint8_t> felled = felled_in(options.dates, year, may_fall, options.seed);
  for (std::size_t i = 0; i < trees.size(); ++i) {
    if (!felled[i]) continue;
    Tree& tree = trees[i];
    tree.grown.uprooting = felling_of(tree.living, tree.seedling->species, options.dates.toward, year);
    die(tree.living, tree.grown.uprooting.time);
  }
}

/// The number of internodes that stand on all trees.
std::size_t internodes_of(const std::vector<Tree>& trees) {
  std::size_t sum = 0;
  for (const Tree& tree : trees) sum += tree.grown.sizes.empty() ? 0 : tree.grown.sizes.back().internodes;
  return sum;
}

/// The radii of each metamer, year by year; `index` is where in the tree the one of a serial number is.
void add_rings(GrownTree& g, const std::vector<YearRings>& rings, const std::vector<std::int32_t>& index,
               const Wood& wood) {
  assert(g.born.size() == g.size() && g.died.size() == g.size() && g.fell.size() == g.size());
  assert(g.light.size() == g.size() && g.order.size() == g.size() && g.leads.size() == g.size());
  g.first_ring.assign(g.size() + 1, 0);
  for (const YearRings& year : rings)
    for (std::uint32_t serial : year.serial) ++g.first_ring[index[serial] + 1];
  for (std::size_t i = 0; i < g.size(); ++i) g.first_ring[i + 1] += g.first_ring[i];
  g.ring.resize(g.first_ring.back());
  std::vector<std::uint32_t> next = g.first_ring;
  for (const YearRings& year : rings)
    for (std::size_t k = 0; k < year.serial.size(); ++k)
      g.ring[next[index[year.serial[k]]]++] = pipe_radius(wood, year.pipe[k]);
}

/// The living and the fallen in the order in which they were born, so that parents precede children.
GrownTree grown_tree(Tree& tree) {
  const Wood& wood = tree.seedling->species.wood;
  const Metamers& m = tree.living;
  GrownTree g = std::move(tree.grown);
  g.grown = tree.serial - 1;
  std::vector<Part> parts = std::move(tree.fallen);
  for (std::size_t i = 0; i < m.size(); ++i) parts.push_back(part_of(m, i, GrownTree::kNever));
  std::ranges::sort(parts, {}, &Part::serial);
  std::vector<std::int32_t> index(tree.serial, GrownTree::kRoot);
  for (const Part& part : parts) {
    assert(part.serial < index.size() && index[part.serial] == GrownTree::kRoot && "each is born once");
    assert((part.parent == part.serial || index[part.parent] != GrownTree::kRoot) && "parents are older");
    g.parent.push_back(index[part.parent]);
    index[part.serial] = static_cast<std::int32_t>(g.size());
    g.tip.push_back(part.tip);
    g.side.push_back(part.side);
    g.radius.push_back(pipe_radius(wood, part.pipe));
    g.born.push_back(part.born);
    g.died.push_back(part.died);
    g.fell.push_back(part.fell);
    g.light.push_back(part.light);
    g.order.push_back(part.order);
    g.leads.push_back(part.leads);
    if (part.regrown) g.regrown.push_back(static_cast<std::uint32_t>(g.size() - 1));
  }
  auto settle = [&](auto& places) {
    std::erase_if(places, [&](const auto& place) { return index[place.on] == GrownTree::kRoot; });
    for (auto& place : places) place.on = static_cast<std::uint32_t>(index[place.on]);
  };
  settle(g.scars), settle(g.cuts);
  g.axes = axis_nodes(g);  // once, and not for each moment of a film

  if (tree.rings.empty()) return g;
  add_rings(g, tree.rings, index, wood);
  return g;
}

}  // namespace

std::size_t GrownTree::held() const {
  return bytes_of(tip) + bytes_of(side) + bytes_of(parent) + bytes_of(radius) + bytes_of(born) +
         bytes_of(died) + bytes_of(fell) + bytes_of(light) + bytes_of(order) + bytes_of(leads) +
         bytes_of(first_ring) + bytes_of(ring) + bytes_of(scars) + bytes_of(cuts) + bytes_of(regrown) +
         bytes_of(axes);
}

bool GrownTree::bears_leaves(const Species& s, std::size_t i, float year) const {
  assert(i < size());
  if (parent[i] == kRoot || born[i] > year || died[i] <= year || fell[i] <= year) return false;
  return leads[i] || year - born[i] < static_cast<float>(s.leaf_years) - 0.001f;
}

std::vector<GrownTree> grow_grove(const std::vector<Seedling>& seedlings, const GroveOptions& options) {
  std::vector<Tree> trees(seedlings.size());
  std::vector<GrownTree> grown(seedlings.size());
  if (trees.empty()) return grown;
  assert(options.years >= 0);
  for (std::size_t i = 0; i < trees.size(); ++i) trees[i].seedling = &seedlings[i];
  LightField field(options.light);
  std::vector<Tree> before;
  for (int year = 0; year < options.years; ++year) {
    if (options.most_internodes > 0) before = trees;
    cast_light(field, trees, options, year);
    Weather storm = weather_of(options.wind, options.snow, options.dates, options.seed, year);
    parallel_for(trees.size(), [&](std::size_t i) { live_a_year(trees[i], field, options, storm, year); });
    fell(trees, options, year);
    if (options.most_internodes > 0 && year > 0 && internodes_of(trees) > options.most_internodes) {
      trees = std::move(before);
      break;
    }
  }
  parallel_for(trees.size(), [&](std::size_t i) {
    if (trees[i].living.size() == 0) plant(trees[i]);
    grown[i] = grown_tree(trees[i]);
  });
  return grown;
}

}  // namespace frond
