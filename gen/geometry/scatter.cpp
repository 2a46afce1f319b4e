#include "geometry/scatter.h"

#include <algorithm>
#include <cmath>

namespace frond {

std::vector<Spot> scatter(Vec2 centre, double inner, double outer, float radius, int count,
                          const std::vector<Spot>& taken, Seed seed) {
  constexpr int kDartsEach = 60;
  std::vector<Spot> spots;
  auto free = [&](Vec2 at, const std::vector<Spot>& others) {
    return std::none_of(others.begin(), others.end(), [&](const Spot& other) {
      return glm::distance(at, other.at) < radius + other.radius;
    });
  };
  for (int i = 0; i < count; ++i) {
    for (int dart = 0; dart < kDartsEach; ++dart) {
      Seed throw_seed = seed.child(static_cast<std::uint64_t>(i)).child(static_cast<std::uint64_t>(dart));
      double angle = throw_seed.child("angle").range(0, 2 * kPi);
      double distance = std::sqrt(throw_seed.child("distance").range(inner * inner, outer * outer));
      Vec2 at = centre + Vec2(static_cast<float>(distance * std::cos(angle)),
                              static_cast<float>(distance * std::sin(angle)));
      if (!free(at, taken) || !free(at, spots)) continue;
      spots.push_back({at, radius});
      break;
    }
  }
  return spots;
}

}  // namespace frond
