#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "organisms/ivy/ivy_forms.h"
#include "organisms/ivy/ivy_rest.h"

namespace frond {

namespace {

constexpr std::uint32_t kHeadings = 8;       // directions of the stem that sprigs are made for
constexpr std::uint32_t kSprigVariants = 3;  // of each
constexpr int kSprigLeaves = 6;

// Where tips point, beside 1 straight down: away from the stem, and at random to either side.
constexpr float kTipAside = 0.65f, kTipScatter = 0.25f;

/// What all sites have in common.
struct Plan {
  const Strands& strands;
  const IvyLeaves& leaves;
  const Support& under;
  Vec3 light;
  Seed seed;
};

/// A site and what is known of it besides.
struct Bud {
  MosaicSite site;
  std::int32_t node = 0;
  std::uint32_t id = 0;
  float youth = 0;  // 0 grown .. 1 at a tip
  float age = 0;    // 0 laid down last .. 1 first
};

Vec3 heading_at(const Skeleton& s, std::int32_t i) {
  std::int32_t p = s.parent[i];
  bool goes_on = i + 1 < static_cast<std::int32_t>(s.size()) && s.parent[i + 1] == i;
  Vec3 direction = goes_on ? s.position[i + 1] - s.position[i] : Vec3(0);
  if (p != Skeleton::kRoot) direction += s.position[i] - s.position[p];
  float length = glm::length(direction);
  return length > 0 ? direction / length : Vec3(0, 1, 0);
}

/// Away from the wall, or round a strand that hangs.
Vec3 outward(const Plan& plan, std::int32_t node, Vec3 heading, std::uint32_t count) {
  Vec3 n = plan.strands.normal[node];
  if (plan.strands.hanging[node] == 0) return n;
  n = glm::angleAxis(static_cast<float>(kGoldenAngle * count), heading) * n;
  Vec3 level = n - heading * glm::dot(n, heading);
  return glm::dot(level, level) > 1e-6f ? glm::normalize(level) : plan.light;
}

/// Which of the shapes a leaf has: drawn-out ones on runners, hearts on old wood.
IvyForm shape_at(const Plan& plan, const Bud& bud, Seed own) {
  constexpr float kOldFrom = 0.55f, kRunner = 0.4f;  // least age, and least youth
  // Chances, by eye: of arrows on runners; elsewhere of five lobes, on young and the fewer on old wood, and
  // of five or three.
  constexpr double kArrows = 0.6, kFives = 0.62, kFewerFives = 0.3, kFivesAndThrees = 0.9;
  double chance = own.child(5).unit();
  if (bud.age > kOldFrom && bud.youth <= 0 && chance < plan.leaves.adult) return IvyForm::heart;
  chance = own.child(6).unit();
  if (bud.youth > kRunner) return chance < kArrows ? IvyForm::arrow : IvyForm::five;
  if (chance < kFives - kFewerFives * bud.age) return IvyForm::five;
  return chance < kFivesAndThrees ? IvyForm::three : IvyForm::arrow;
}

Bud bud_at(const Plan& plan, std::int32_t node, std::uint32_t count, Seed own) {
  constexpr float kScatter = 0.16f;                  // of a normal, in each direction
  constexpr float kOutward = 0.35f;                  // what a normal has of the wall's, at least
  constexpr float kAhead = 0.2f;                     // of a tip, along the stem
  constexpr float kHangingOut = 0.35f;               // of a tip on a strand that hangs, away from it
  constexpr float kTipSize = 0.30f, kGrows = 0.70f;  // of its size: at a tip, and what is added below
  const Skeleton& s = plan.strands.skeleton;
  const IvyLeaves& l = plan.leaves;
  Vec3 heading = heading_at(s, node), normal = outward(plan, node, heading, count);
  Vec3 across = glm::cross(normal, heading);
  float side = count % 2 ? 1.0f : -1.0f;
  auto random = [&](std::uint64_t i) { return static_cast<float>(own.child(i).range(-1, 1)); };
  Bud bud;
  bud.node = node;
  bud.age = 1 - s.birth[node];
  bud.youth = 1 - smooth_step(0.0f, static_cast<float>(std::max(l.young_length, 1e-4)), s.to_tip[node]);
  MosaicSite& site = bud.site;
  site.foot = s.position[node] + 0.5f * s.radius[node] * normal;
  float turn = static_cast<float>(l.turn);
  Vec3 best = (1 - turn) * normal + turn * plan.light + kScatter * Vec3(random(0), random(1), random(2));
  // A blade never looks into the wall.
  float away = glm::dot(best, normal);
  if (away < kOutward) best += (kOutward - away) * normal;
  site.normal = glm::normalize(best);
  site.tip = Vec3(0, -1, 0) + kTipAside * side * across + kAhead * heading +
             kTipScatter * random(3) * across +
             kHangingOut * normal * static_cast<float>(plan.strands.hanging[node]);
  float grown = kTipSize + kGrows * (1 - bud.youth);
  site.size = static_cast<float>(l.size) * grown * (1 + static_cast<float>(l.size_variation) * random(4));
  return bud;
}

/// Sites along all strands, one every `step` metres, the oldest first.
std::vector<Bud> buds_along(const Plan& plan, double step) {
  const Skeleton& s = plan.strands.skeleton;
  std::vector<Bud> buds;
  for (std::size_t k = 0; k < plan.strands.strands.size(); ++k) {
    const Strand& strand = plan.strands.strands[k];
    Seed seed = plan.seed.child(k);
    double walked = 0, next = step * seed.child(0).range(0.3, 1);
    std::uint32_t count = static_cast<std::uint32_t>(seed.child(1).bits() % 2);
    for (std::int32_t i = strand.first; i < strand.first + strand.count; ++i) {
      if (i > strand.first) walked += glm::distance(s.position[i], s.position[i - 1]);
      if (walked < next) continue;
      Seed own = seed.child("leaf", count);
      next += step * own.child(7).range(0.7, 1.3);
      ++count;
      if (s.distance[i] < plan.leaves.bare * own.child(8).range(0.6, 1.5)) continue;
      if (!plan.strands.mask.empty() && own.child(10).unit() >= plan.strands.mask[i]) continue;
      buds.push_back(bud_at(plan, i, count, own));
      Bud& bud = buds.back();
      bud.id = static_cast<std::uint32_t>(own.bits());
      if (!plan.leaves.picture)
        bud.site.first = static_cast<std::uint32_t>(shape_at(plan, bud, own)) * kPetioles;
      bud.site.forms = kPetioles;
      bud.site.prefer = static_cast<std::uint32_t>(own.child(9).bits() % kPetioles);
    }
  }
  std::stable_sort(buds.begin(), buds.end(), [](const Bud& a, const Bud& b) { return a.age > b.age; });
  return buds;
}

/// Lays leaves down on what is under them, some on another petiole or smaller. What finds no rest is dropped.
void rest_all(const Plan& plan, const std::vector<Feelers>& feelers, float slide, std::vector<Bud>& buds,
              std::vector<LaidLeaf>& laid) {
  constexpr std::size_t kBlock = 64;
  constexpr float kSmaller = 0.6f;  // of its size, as a last attempt
  std::vector<std::uint8_t> rests(laid.size(), 0);
  auto lay_down = [&](std::size_t i) {
    MosaicSite& site = buds[laid[i].site].site;
    Vec3 out = plan.strands.normal[buds[laid[i].site].node];
    std::uint32_t tallest = site.forms == kPetioles ? site.first + kTallest : laid[i].form;
    for (auto [form, size] : {std::pair(laid[i].form, 1.0f), {tallest, 1.0f}, {tallest, kSmaller}}) {
      Rest rest{site.foot, laid[i].turn};
      if (!lie_on(plan.under, feelers[form], size * site.size, slide, out, rest)) continue;
      laid[i].form = form, laid[i].turn = rest.turn;
      site.foot = rest.foot, site.size *= size;
      rests[i] = 1;
      return;
    }
  };
  parallel_for((laid.size() + kBlock - 1) / kBlock, [&](std::size_t b) {
    for (std::size_t i = b * kBlock; i < std::min((b + 1) * kBlock, laid.size()); ++i) lay_down(i);
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < laid.size(); ++i)
    if (rests[i]) laid[kept++] = laid[i];
  laid.resize(kept);
}

std::vector<MosaicSite> sites_of(const std::vector<Bud>& buds) {
  std::vector<MosaicSite> sites;
  for (const Bud& bud : buds) sites.push_back(bud.site);
  return sites;
}

/// A sprig: leaves along a piece of stem that lies in the plane z = 0 and runs in a direction; down is +y.
struct IvySprig {
  Surface surface;
  LeafForm form;
};

IvySprig sprig_of(const std::vector<LeafForm>& forms, const IvyLeaves& l, double heading, Seed seed) {
  constexpr double kUneven = 0.3;   // of the spacing, along the stem
  constexpr float kScatter = 0.2f;  // of a normal, to either side
  constexpr float kToLight = 0.9f;  // how much it leans up for IvyLeaves::turn
  constexpr double kFives = 0.6;    // share of leaves with five lobes; the others have three
  Vec3 along(std::sin(heading), std::cos(heading), 0);
  Vec3 across(-along.y, along.x, 0);
  std::vector<MosaicSite> sites;
  for (int i = 0; i < kSprigLeaves; ++i) {
    Seed own = seed.child(static_cast<std::uint64_t>(i));
    auto random = [&](std::uint64_t k) { return static_cast<float>(own.child(k).range(-1, 1)); };
    MosaicSite site;
    double place = (i - 0.5 * (kSprigLeaves - 1) + kUneven * random(0)) * l.spacing / l.size;
    site.foot = along * static_cast<float>(place);
    site.normal = glm::normalize(
        Vec3(kScatter * random(1), -kToLight * static_cast<float>(l.turn) + kScatter * random(2), 1));
    site.tip = Vec3(0, 1, 0) + (i % 2 ? kTipAside : -kTipAside) * across + kTipScatter * random(3) * across;
    site.size = 1 + static_cast<float>(l.size_variation) * random(4);
    IvyForm form = own.child(5).unit() < kFives ? IvyForm::five : IvyForm::three;
    site.first = l.picture ? 0 : static_cast<std::uint32_t>(form) * kPetioles;
    site.forms = kPetioles;
    site.prefer = static_cast<std::uint32_t>(own.child(6).bits() % kPetioles);
    sites.push_back(site);
  }
  MosaicOptions options;
  options.overlap = 1e6;
  IvySprig sprig;
  for (const LaidLeaf& leaf : lay_leaves(sites, forms, options)) {
    const MosaicSite& site = sites[leaf.site];
    Surface blade = leaf_of(l, leaf.form, 0);
    for (Vec3& p : blade.position) p = site.foot + leaf.turn * (p * site.size);
    for (Vec3& n : blade.normal) n = leaf.turn * n;
    append(sprig.surface, blade);
    for (const Disc& d : forms[leaf.form].discs)
      sprig.form.discs.push_back(
          {site.foot + leaf.turn * (d.middle * site.size), leaf.turn * d.normal, d.radius * site.size});
  }
  return sprig;
}

/// Colours of grown leaves, then each of them mixed with that of young ones: of half fresh leaves, and of
/// fresh ones.
std::vector<Color> leaf_colors(const IvyLeaves& l) {
  constexpr float kHalfFresh = 0.45f, kMostlyYoung = 0.85f;  // shares of the young colour
  std::vector<Color> colors = l.colors;
  for (float share : {kHalfFresh, kMostlyYoung})
    for (const Color& c : l.colors) colors.push_back(mixed(c, l.young, share));
  return colors;
}

std::int32_t color_of(const IvyLeaves& l, const Bud& bud) {
  constexpr double kHalfFreshFrom = 0.3, kFreshFrom = 0.7, kEitherWay = 0.2;  // of the bud's youth
  std::uint64_t count = (l.picture ? l.picture->colors : l.colors).size();
  Seed own = Seed{bud.id}.child("color");
  auto which = static_cast<std::int32_t>(own.child(0).bits() % count);
  if (l.picture) return which;
  double fresh = bud.youth + own.child(1).range(-kEitherWay, kEitherWay);
  return which + static_cast<std::int32_t>(count) * (fresh > kFreshFrom ? 2 : fresh > kHalfFreshFrom ? 1 : 0);
}

void add_prototype(Model& model, const IvyLeaves& l, const char* name, Surface surface) {
  Prototype made{name, {}, leaf_colors(l), l.veins, l.bud};
  if (l.picture) {
    made = leaf_prototype(*l.picture);
    made.name = name;
    made.parts.front().surface = std::move(surface);
  } else {
    made.parts.push_back({Tissue::ivy, std::move(surface)});
  }
  model.prototypes.push_back(std::move(made));
}

void add_organ(Model& model, const Plan& plan, const Bud& bud, const LaidLeaf& leaf, float supple) {
  Organs& o = model.organs;
  o.prototype.push_back(static_cast<std::uint16_t>(leaf.form));
  o.position.push_back(bud.site.foot);
  o.turn.push_back(leaf.turn);
  o.scale.push_back(Vec3(std::max(bud.site.size, 1e-5f)));
  o.node.push_back(bud.node);
  o.birth.push_back(plan.strands.skeleton.birth[bud.node]);
  o.color.push_back(color_of(plan.leaves, bud));
  o.id.push_back(bud.id);
  o.supple.push_back(supple);
}

std::size_t add_single_leaves(Model& model, const Plan& plan, std::vector<Bud>& buds,
                              const std::vector<LeafForm>& forms, std::vector<LaidLeaf>& laid) {
  constexpr std::size_t kFewLeaves = 6000;               // below that many they are drawn in full detail
  constexpr float kFeelersApart = 0.09f, kSlide = 0.1f;  // in lengths of the blade
  constexpr double kSuppleStalk = 0.05;                  // metres; it flutters by 1 (Organs::supple)
  int detail = laid.size() < kFewLeaves ? 2 : 1;
  std::vector<Feelers> feelers;
  std::vector<double> stalks;
  for (std::uint32_t i = 0; i < forms.size(); ++i) {
    stalks.push_back(stalk_of(plan.leaves, i));
    Surface leaf = leaf_of(plan.leaves, i, detail);
    feelers.push_back(feelers_of(felt(plan.leaves, leaf), kFeelersApart));
    add_prototype(model, plan.leaves, "leaf", std::move(leaf));
  }
  rest_all(plan, feelers, kSlide, buds, laid);
  for (const LaidLeaf& leaf : laid) {
    const Bud& bud = buds[leaf.site];
    double stalk = stalks[leaf.form] * bud.site.size;
    add_organ(model, plan, bud, leaf, static_cast<float>(stalk / kSuppleStalk));
  }
  return laid.size();
}

/// Whether so few leaves may find room that each can be one by itself. Of sites on long strands a tenth does
/// at least, so that with very many there is no need to try.
bool may_be_single(const Strands& strands, const IvyLeaves& leaves) {
  double length = 0;
  for (const Strand& s : strands.strands)
    length += strands.skeleton.distance[s.first + s.count - 1] - strands.skeleton.distance[s.first];
  return length < 10 * kMostSingleLeaves * leaves.spacing;
}

std::size_t add_sprigs(Model& model, const Plan& plan, const std::vector<LeafForm>& leaf_forms) {
  constexpr float kFeelersApart = 0.16f, kSlide = 0.6f;  // in lengths of a blade
  constexpr float kSupple = 0.25f;                       // less than a leaf, as leaves hold each other
  std::vector<LeafForm> forms;
  std::vector<Feelers> feelers;
  for (std::uint32_t h = 0; h < kHeadings; ++h)
    for (std::uint32_t v = 0; v < kSprigVariants; ++v) {
      Seed own = plan.seed.child("sprig", h * kSprigVariants + v);
      IvySprig sprig = sprig_of(leaf_forms, plan.leaves, 2 * kPi * h / kHeadings, own);
      feelers.push_back(feelers_of(felt(plan.leaves, sprig.surface), kFeelersApart));
      add_prototype(model, plan.leaves, "sprig", std::move(sprig.surface));
      forms.push_back(std::move(sprig.form));
    }
  std::vector<Bud> buds = buds_along(plan, kSprigLeaves * plan.leaves.spacing);
  for (Bud& bud : buds) {
    // Seen from outside, the angle from straight down to the stem tells which sprigs fit.
    Vec3 n = outward(plan, bud.node, heading_at(plan.strands.skeleton, bud.node), 0);
    bud.site.normal = n;
    bud.site.tip = Vec3(0, -1, 0);
    Vec3 stem = glm::conjugate(leaf_turn(n, bud.site.tip)) * heading_at(plan.strands.skeleton, bud.node);
    double angle = std::atan2(stem.x, stem.y) / (2 * kPi) * kHeadings;
    auto bin = static_cast<std::uint32_t>(std::lround(angle) + 2 * kHeadings) % kHeadings;
    bud.site.first = bin * kSprigVariants;
    bud.site.forms = kSprigVariants;
    bud.site.prefer %= kSprigVariants;
  }
  MosaicOptions options;
  options.overlap = plan.leaves.overlap, options.swing = radians(20.0), options.turns = 3;
  std::vector<LaidLeaf> laid = lay_leaves(sites_of(buds), forms, options);
  rest_all(plan, feelers, kSlide, buds, laid);
  std::size_t count = 0;
  for (const LaidLeaf& leaf : laid) {
    add_organ(model, plan, buds[leaf.site], leaf, kSupple);
    count += forms[leaf.form].discs.size();
  }
  return count;
}

}  // namespace

std::size_t add_ivy_leaves(Model& model, const Strands& strands, const IvyLeaves& leaves,
                           const Support& under, Seed seed) {
  float length = glm::length(leaves.light);
  Plan plan{strands, leaves, under, length > 0 ? leaves.light / length : Vec3(0, 1, 0), seed};
  model.prototypes.clear();
  model.organs = {};
  std::vector<LeafForm> forms = leaf_forms(leaves);
  bool all = leaves.detail == IvyDetail::leaves;
  if (all || (leaves.detail == IvyDetail::fitting && may_be_single(strands, leaves))) {
    std::vector<Bud> buds = buds_along(plan, leaves.spacing);
    MosaicOptions options;
    options.overlap = leaves.overlap;
    if (!all) options.most = kMostSingleLeaves + 1;
    std::vector<LaidLeaf> laid = lay_leaves(sites_of(buds), forms, options);
    if (all || laid.size() <= kMostSingleLeaves) return add_single_leaves(model, plan, buds, forms, laid);
  }
  return add_sprigs(model, plan, forms);
}

}  // namespace frond
