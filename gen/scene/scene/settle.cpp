#include "scene/settle.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/discrete_distribution.h"
#include "core/triangle.h"
#include "scene/entry_seeds.h"

namespace frond {

namespace {

constexpr float kOverhang = -0.35f;    // what faces down by more bears no colony
constexpr int kFruitlessDarts = 1000;  // in a row, before it is given up
constexpr double kPlumb = 1e3;         // metres above and below, that a plumb line goes

/// The triangles that a colony may stand on.
DiscreteDistribution lots_on(const TriangleSurface& host) {
  DiscreteDistribution lots;
  for (std::uint32_t t = 0; t < host.triangles().size(); ++t) {
    const auto& [a, b, c] = host.triangles()[t];
    lots.add(host.face_normal(t).y > kOverhang ? triangle_area(a, b, c) : 0);
  }
  return lots;
}

/// A place on the host, each as likely as any other.
Planting sample_place(const TriangleSurface& host, const DiscreteDistribution& lots, Seed lot) {
  auto t = static_cast<std::uint32_t>(lots.drawn(lot.child("triangle").unit()));
  const auto& [a, b, c] = host.triangles()[t];
  Vec3 share(drawn_weights(lot.child("u").unit(), lot.child("v").unit()));
  return {.seed = {}, .foot = a * share.x + b * share.y + c * share.z, .normal = Vec3(host.face_normal(t))};
}

/// What has found its foot on a body, and the room it keeps.
struct Settled {
  Vec3 foot;
  float room;
};

bool is_free(const std::vector<Settled>& settled, Vec3 at, float room) {
  return std::ranges::none_of(settled,
                              [&](const Settled& s) { return glm::distance(s.foot, at) < s.room + room; });
}

/// An error's `where` is a pointer into the preset.
Errors settle_on_bodies(const Preset& preset, Bed& bed, const World& world, std::vector<Settled>& settled,
                        std::vector<std::string>& notes) {
  const Organism& organism = *bed.organism;
  const Place& place = organism.place;
  Result<std::shared_ptr<const TriangleSurface>> host = world.host(place.on, organism.name);
  if (!host)
    return {Error{fmt::format("/organisms/{}/place/on", bed.entry),
                  host.errors().front().what + "; expected bodies to stand on, such as rocks"}};
  auto room = static_cast<float>(place.spacing);
  for (Planting& planting : bed.plantings) {  // those of `at`
    DVec3 at(planting.foot);
    auto met = (*host)->crossing(at + DVec3(0, kPlumb, 0), at - DVec3(0, kPlumb, 0));
    if (met) {
      planting.foot.y = static_cast<float>(at.y + kPlumb * (1 - 2 * met->share));
      planting.normal = Vec3(met->normal);
    }
    settled.push_back({planting.foot, room});
  }
  DiscreteDistribution lots = lots_on(**host);
  if (lots.sum() <= 0) return {};
  Seed darts = bed.seed.child("settle");
  int fruitless = 0;
  for (std::uint64_t dart = 0; std::ssize(bed.plantings) < organism.count && fruitless < kFruitlessDarts;
       ++dart) {
    Planting planting = sample_place(**host, lots, darts.child(dart));
    double away = glm::distance(Vec2(planting.foot.x, planting.foot.z), place.center);
    bool fits = away >= place.inner && away <= place.radius && is_free(settled, planting.foot, room);
    fruitless = fits ? 0 : fruitless + 1;
    if (!fits) continue;
    planting.seed = planting_seed(preset, bed.seed, "settled", bed.plantings.size(), dart);
    settled.push_back({planting.foot, room});
    bed.plantings.push_back(planting);
  }
  if (std::ssize(bed.plantings) < organism.count)
    notes.push_back(fmt::format("{}: only {} of {} found room on what they stand on", organism.name,
                                bed.plantings.size(), organism.count));
  return {};
}

}  // namespace

Errors settle_colonies(const Preset& preset, std::vector<Bed>& beds, World& world,
                       std::vector<std::string>& notes) {
  std::vector<Settled> settled;
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

}  // namespace frond
