#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/discrete_distribution.h"
#include "core/ease.h"
#include "core/triangle.h"
#include "land/suitability.h"
#include "scene/entry_seeds.h"
#include "scene/sowing.h"

// Copies that are sown over bodies: `place.on` with `sown`.

namespace frond {

namespace {

constexpr std::uint64_t kDarts = 40;   // thrown for each copy before it is given up
constexpr int kPatience = 500;         // copies in a row that find no room before the others are given up
constexpr float kOfColony = 0.45f;     // of the reach of a colony, that copies keep from its foot
constexpr double kFarthestHost = 1e3;  // metres from the middle
constexpr double kSlopeEdge = 0.8;     // of the steepest slope, from which on copies become fewer

/// What has found room, in cells so large that two that touch are in neighbouring ones.
class Crowd {
 public:
  explicit Crowd(float largest) : cell_(2 * largest) {}

  void add(Vec3 at, float radius) { cells_[key(at, {0, 0, 0})].push_back({at, radius}); }
  bool touches(Vec3 at, float radius) const {
    for (int k = 0; k < 27; ++k) {
      auto found = cells_.find(key(at, {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1}));
      if (found == cells_.end()) continue;
      for (const Ball& ball : found->second)
        if (glm::distance(ball.at, at) < ball.radius + radius) return true;
    }
    return false;
  }

 private:
  struct Ball {
    Vec3 at;
    float radius;
  };
  using Key = std::tuple<int, int, int>;
  Key key(Vec3 at, glm::ivec3 aside) const {
    glm::ivec3 cell = glm::ivec3(glm::floor(at / cell_)) + aside;
    return {cell.x, cell.y, cell.z};
  }

  float cell_;
  std::map<Key, std::vector<Ball>> cells_;
};

/// Where a copy may stand, and how its surface faces.
struct SurfacePoint {
  Vec3 at{0}, normal{0, 1, 0};
};

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
    for (std::uint32_t t = 0; t < host.triangles().size(); ++t) {
      const auto& [a, b, c] = host.triangles()[t];
      lots_.add(slope_share(rules_, host.face_normal(t).y) > 0 ? triangle_area(a, b, c) : 0);
    }
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
      add_copy(copies, organism_, own, spot->at, spot->normal, size,
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
      auto t = static_cast<std::uint32_t>(lots_.drawn(toss.child("triangle").unit()));
      const auto& [a, b, c] = host_.triangles()[t];
      Vec3 share(drawn_weights(toss.child("u").unit(), toss.child("v").unit()));
      SurfacePoint spot{a * share.x + b * share.y + c * share.z, Vec3(host_.face_normal(t))};
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
    Result<std::shared_ptr<const TriangleSurface>> host = world.host(organism.place.on, organism.name);
    if (!host)
      return {Error{fmt::format("/organisms/{}/place/on", set->entry),
                    host.errors().front().what + "; expected bodies to stand on, such as rocks"}};
    const SowRules& where = organism.sown->where;
    auto largest = static_cast<float>(where.radius * (1 + organism.place.size_variation));
    auto [crowd, added] = crowds.try_emplace(where.layer, std::max(largest, 0.25f));
    if (added)
      for (std::size_t i = 0; i < world.territories().size(); ++i) {
        const Claim& claim = world.territories().claim(i);
        crowd->second.add(claim.foot, std::min(kOfColony * claim.across, 0.25f));
      }
    int found = BodySower(organism, **host, world, seeds[set->entry]).sow(crowd->second, set->copies);
    if (found < organism.count)
      scene.notes.push_back(room_note(organism, set->entry, static_cast<std::size_t>(found)));
  }
  return {};
}

}  // namespace frond
