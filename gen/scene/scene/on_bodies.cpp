#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/cell_grid.h"
#include "core/discrete_distribution.h"
#include "core/triangle.h"
#include "land/suitability.h"
#include "scene/entry_seeds.h"
#include "scene/sowing.h"

namespace frond {

namespace {

constexpr std::uint64_t kDarts = 40;   // thrown for each copy before it is given up
constexpr int kPatience = 500;         // copies in a row that find no room before the others are given up
constexpr float kOfColony = 0.45f;     // of the reach of a colony, that copies keep from its foot
constexpr float kUnderColony = 0.12f;  // those of the lowest layer, which grow up to it
constexpr double kFarthestHost = 1e3;  // metres from the middle
constexpr double kSlopeEdge = 0.8;     // of the steepest slope, from which on copies become fewer
constexpr float kOverhang = -0.35f;    // what faces down by more bears no colony
constexpr int kFruitlessDarts = 1000;  // of colonies in a row, before they are given up
constexpr double kPlumb = 1e3;         // metres above and below, that a plumb line goes

/// What has found room; none is larger than `largest`.
class Crowd {
 public:
  explicit Crowd(float largest) : grid_(2 * largest) {}

  void add(Vec3 at, float radius) {
    grid_.add(at, static_cast<std::uint32_t>(balls_.size()));
    balls_.push_back({at, radius});
  }
  bool touches(Vec3 at, float radius) const {
    bool touched = false;
    grid_.each(at, [&](std::uint32_t who) {
      const Ball& ball = balls_[who];
      touched = touched || glm::distance(ball.at, at) < ball.radius + radius;
    });
    return touched;
  }

 private:
  struct Ball {
    Vec3 at;
    float radius;
  };
  CellGrid grid_;
  std::vector<Ball> balls_;
};

/// The bodies that an entry stands on; an error's `where` is a pointer into the preset.
Result<std::shared_ptr<const TriangleSurface>> bodies_under(const Organism& organism, std::size_t entry,
                                                            const World& world) {
  Result<std::shared_ptr<const TriangleSurface>> host = world.host(organism.place.on, organism.name);
  if (host) return host;
  return Error{fmt::format("/organisms/{}/place/on", entry),
               host.errors().front().what + "; expected bodies to stand on, such as rocks"};
}

/// The triangles of a host that suit by how far up they face.
template <class Suits>
DiscreteDistribution lots_on(const TriangleSurface& host, const Suits& suits) {
  DiscreteDistribution lots;
  for (std::uint32_t t = 0; t < host.triangles().size(); ++t) {
    const auto& [a, b, c] = host.triangles()[t];
    lots.add(suits(host.face_normal(t).y) ? triangle_area(a, b, c) : 0);
  }
  return lots;
}

/// Where something may stand, and how its surface faces.
struct SurfacePoint {
  Vec3 at{0}, normal{0, 1, 0};
};

/// A place on the host, each as likely as any other.
SurfacePoint sample_place(const TriangleSurface& host, const DiscreteDistribution& lots, Seed lot) {
  auto t = static_cast<std::uint32_t>(lots.drawn(lot.child("triangle").unit()));
  const auto& [a, b, c] = host.triangles()[t];
  Vec3 share(drawn_weights(lot.child("u").unit(), lot.child("v").unit()));
  return {a * share.x + b * share.y + c * share.z, Vec3(host.face_normal(t))};
}

/// An error's `where` is a pointer into the preset.
Errors settle_on_bodies(const Preset& preset, Bed& bed, const World& world, Crowd& settled,
                        std::vector<std::string>& notes) {
  const Organism& organism = *bed.organism;
  const Place& place = organism.place;
  Result<std::shared_ptr<const TriangleSurface>> host = bodies_under(organism, bed.entry, world);
  if (!host) return host.errors();
  auto room = static_cast<float>(place.spacing);
  for (Planting& planting : bed.plantings) {  // those of `at`
    DVec3 at(planting.foot);
    auto met = (*host)->crossing(at + DVec3(0, kPlumb, 0), at - DVec3(0, kPlumb, 0));
    if (met) {
      planting.foot.y = static_cast<float>(at.y + kPlumb * (1 - 2 * met->share));
      planting.normal = Vec3(met->normal);
    }
    settled.add(planting.foot, room);
  }
  DiscreteDistribution lots = lots_on(**host, [](auto up) { return up > kOverhang; });
  if (lots.sum() <= 0) return {};
  Seed darts = bed.seed.child("settle");
  int fruitless = 0;
  for (std::uint64_t dart = 0; std::ssize(bed.plantings) < organism.count && fruitless < kFruitlessDarts;
       ++dart) {
    SurfacePoint spot = sample_place(**host, lots, darts.child(dart));
    double away = glm::distance(Vec2(spot.at.x, spot.at.z), place.center);
    bool fits = away >= place.inner && away <= place.radius && !settled.touches(spot.at, room);
    fruitless = fits ? 0 : fruitless + 1;
    if (!fits) continue;
    settled.add(spot.at, room);
    bed.plantings.push_back(
        {planting_seed(preset, bed.seed, "settled", bed.plantings.size(), dart), spot.at, spot.normal});
  }
  if (std::ssize(bed.plantings) < organism.count)
    notes.push_back(fmt::format("{}: only {} of {} found room on what they stand on", organism.name,
                                bed.plantings.size(), organism.count));
  return {};
}

/// How well a surface that faces there suits, 0..1.
double slope_share(const SowRules& rules, double up) {
  return 1 - smooth_step(kSlopeEdge * rules.slope, rules.slope, std::acos(std::clamp(up, -1.0, 1.0)));
}

/// Sows one organism over its bodies.
class BodySower {
 public:
  BodySower(const Organism& organism, const TriangleSurface& host, const World& world, Seed seed)
      : organism_(organism), rules_(organism.sown->where), host_(host), world_(world), seed_(seed) {
    land_.size = 2 * kFarthestHost;
    flat_.slope = kPi;  // which is asked of the body here
    flat_.shade = {0, 1};
    lots_ = lots_on(host, [&](double up) { return slope_share(rules_, up) > 0; });
  }

  /// Number of copies that found room.
  int sow(Crowd& crowd, Copies& copies) const {
    if (lots_.sum() <= 0) return 0;
    Suitability suits(flat_, land_, {}, seed_);
    int missed = 0;
    for (int i = 0; i < organism_.count && missed < kPatience; ++i) {
      Seed own = seed_.child("sprout", static_cast<std::uint64_t>(i));
      auto size = static_cast<float>(sprout_size(organism_.place.size_variation, own));
      auto radius = static_cast<float>(rules_.radius) * size;
      std::optional<SurfacePoint> spot = find_room(suits, crowd, own, radius);
      ++missed;
      if (!spot) continue;
      missed = 0;
      crowd.add(spot->at, radius);
      // What is raised or sunk is so along the normal, which add_copy() does upward.
      Vec3 aside = static_cast<float>(organism_.place.raise) * (spot->normal - Vec3(0, 1, 0));
      add_copy(copies, organism_, own, spot->at + aside, spot->normal, size,
               static_cast<std::uint16_t>(own.child("model").bits() %
                                          static_cast<unsigned>(organism_.sown->models)));
    }
    return static_cast<int>(copies.size());
  }

 private:
  std::optional<SurfacePoint> find_room(const Suitability& suits, const Crowd& crowd, Seed own,
                                        float radius) const {
    for (std::uint64_t dart = 0; dart < kDarts; ++dart) {
      Seed toss = own.child("dart").child(dart);
      SurfacePoint spot = sample_place(host_, lots_, toss);
      Vec2 flat(spot.at.x, spot.at.z);
      if (crowd.touches(spot.at, radius)) continue;
      if (slope_share(rules_, spot.normal.y) * suits(flat) <= toss.child("kept").unit()) continue;
      // Where bodies overlap, or stand in the ground.
      if (host_.inside(DVec3(spot.at + 0.3f * radius * spot.normal)) || world_.height(flat) > spot.at.y)
        continue;
      if (rules_.shade != Vec2(0, 1)) {
        double hidden = 1 - world_.open_sky(DVec3(spot.at));
        if (hidden < rules_.shade.x || hidden > rules_.shade.y) continue;
      }
      return spot;
    }
    return {};
  }

  const Organism& organism_;
  const SowRules& rules_;
  const TriangleSurface& host_;
  const World& world_;
  Seed seed_;
  SowRules flat_ = rules_;
  Land land_;  // level, without anything to keep clear
  DiscreteDistribution lots_;
};

}  // namespace

Errors settle_colonies(const Preset& preset, std::vector<Bed>& beds, World& world,
                       std::vector<std::string>& notes) {
  float largest = 0.001f;
  for (const Bed& bed : beds) largest = std::max(largest, static_cast<float>(bed.organism->place.spacing));
  Crowd settled(largest);
  std::vector<Claim> claims;
  for (Bed& bed : beds) {
    if (!bed.organism->place.on.empty())
      if (Errors errors = settle_on_bodies(preset, bed, world, settled, notes); !errors.empty())
        return errors;
    std::optional<Spread> spread = bed.organism->grower->spread();
    if (!spread) continue;
    for (Planting& planting : bed.plantings) {
      float size = size_of(*bed.organism, planting);
      planting.claim = claims.size();
      claims.push_back({planting.foot, size * spread->across, size * spread->up});
    }
  }
  world.settle(Territories(std::move(claims)));
  return {};
}

Errors sow_on_bodies(Scene& scene, const Preset& preset, const World& world) {
  std::vector<CopySet*> sets;
  for (CopySet& set : scene.copy_sets)
    if (!set.organism.place.on.empty()) sets.push_back(&set);
  // The largest first, as on the ground.
  std::ranges::stable_sort(sets, std::greater(), [](const CopySet* set) {
    return std::pair(-static_cast<int>(set->organism.sown->where.layer), set->organism.sown->where.radius);
  });
  std::vector<Seed> seeds = entry_seeds(preset, "organism");
  std::map<Layer, Crowd> crowds;
  for (CopySet* set : sets) {
    const Organism& organism = set->organism;
    Result<std::shared_ptr<const TriangleSurface>> host = bodies_under(organism, set->entry, world);
    if (!host) return host.errors();
    const SowRules& where = organism.sown->where;
    auto largest = static_cast<float>(where.radius * (1 + organism.place.size_variation));
    auto [crowd, added] = crowds.try_emplace(where.layer, std::max(largest, 0.25f));
    if (added)
      for (std::size_t i = 0; i < world.territories().size(); ++i) {
        const Claim& claim = world.territories().claim(i);
        float kept = where.layer == Layer::herbs ? kUnderColony : kOfColony;
        crowd->second.add(claim.foot, std::min(kept * claim.across, 0.25f));
      }
    int found = BodySower(organism, **host, world, seeds[set->entry]).sow(crowd->second, set->copies);
    note_room(scene, organism, set->entry, static_cast<std::size_t>(found));
  }
  return {};
}

}  // namespace frond
