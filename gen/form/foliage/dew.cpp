#include "foliage/dew.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/discrete_distribution.h"
#include "core/triangle.h"
#include "foliage/organ_shapes.h"

namespace frond {

namespace {

constexpr double kMostDrops = 4000;
constexpr float kLeast = 0.0005f, kMost = 0.0028f;  // metres across
constexpr float kSunk = 0.28f, kFlat = 0.82f;       // of a drop's radius: how far it is spread on the skin

}  // namespace

Surface dew_surface(const Surface& organ, double size, double drops, Seed seed) {
  DiscreteDistribution lots;
  for (const auto& [i, j, k] : organ.triangle)
    lots.add(triangle_area(organ.position[i], organ.position[j], organ.position[k]));
  auto wanted = static_cast<std::uint64_t>(std::min(1e4 * drops * lots.sum() * size * size, kMostDrops));
  Surface ball = ball_surface(), dew;
  std::vector<std::pair<Vec3, float>> laid;
  for (std::uint64_t n = 0; n < wanted; ++n) {
    Seed own = seed.child("drop", n);
    const auto& [i, j, k] = organ.triangle[lots.drawn(own.child("at").unit())];
    double u = own.child("u").unit(), v = own.child("v").unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    Vec3 share(1 - u - v, u, v);
    Vec3 normal = share.x * organ.normal[i] + share.y * organ.normal[j] + share.z * organ.normal[k];
    if (glm::dot(normal, normal) < 1e-8f) continue;
    normal = glm::normalize(normal);
    // Most are small.
    auto wide = static_cast<float>(std::pow(own.child("wide").unit(), 2.5));
    float radius = 0.5f * glm::mix(kLeast, kMost, wide) / static_cast<float>(size);
    Vec3 place = share.x * organ.position[i] + share.y * organ.position[j] + share.z * organ.position[k] +
                 (kFlat - kSunk) * radius * normal;
    if (std::ranges::any_of(laid, [&](const auto& other) {
          return glm::distance(other.first, place) < other.second + radius;
        }))
      continue;
    laid.emplace_back(place, radius);
    append_placed(dew, ball, place, Quat(Vec3(0, 1, 0), normal), 2 * radius * Vec3(1, kFlat, 1));
  }
  dew.uv.clear();
  return dew;
}

}  // namespace frond
