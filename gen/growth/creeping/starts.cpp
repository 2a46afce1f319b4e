#include <algorithm>
#include <cmath>

#include "core/discrete_distribution.h"
#include "core/triangle.h"
#include "creeping/crawl.h"

namespace frond {

namespace {

/// Where one triangle is cut by a level plane.
struct Cut {
  DVec3 from, to;
  std::uint32_t triangle;
  double angle;  // round the middle of the host
};

/// Grows with the angle of (x, z) round the origin as the angle itself does, without the library's arcs.
double pseudo_angle(double x, double z) {
  double sum = std::abs(x) + std::abs(z);
  if (sum <= 0) return 0;
  double p = x / sum;
  return z < 0 ? p - 1 : 1 - p;
}

std::vector<Cut> level_cuts(const TriangleSurface& host, double height, const DVec3& facing) {
  constexpr double kFacing = 0.5;  // cosine, of 60 degrees: from `facing` to a face's normal
  std::vector<Cut> cuts;
  DVec3 middle = 0.5 * (host.low() + host.high());
  for (std::uint32_t t = 0; t < host.triangles().size(); ++t) {
    DVec3 ends[3];
    int found = 0;
    for (int i = 0; i < 3; ++i) {
      DVec3 a(host.triangles()[t][i]), b(host.triangles()[t][(i + 1) % 3]);
      if ((a.y < height) == (b.y < height)) continue;
      // From the lower end, so that neighbours cut their common edge in the same point.
      if (a.y > b.y) std::swap(a, b);
      ends[found++] = a + (b - a) * ((height - a.y) / (b.y - a.y));
    }
    if (found != 2) continue;
    if (glm::dot(facing, facing) > 0 && glm::dot(host.face_normal(t), glm::normalize(facing)) < kFacing)
      continue;
    DVec3 half = 0.5 * (ends[0] + ends[1]) - middle;
    cuts.push_back({ends[0], ends[1], t, pseudo_angle(half.x, half.z)});
  }
  std::stable_sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.angle < b.angle; });
  return cuts;
}

}  // namespace

std::vector<Start> starts_at_foot(const TriangleSurface& host, int count, double above, Vec3 facing,
                                  Seed seed) {
  double height = host.low().y + std::clamp(above, 1e-4 * host.size(), host.high().y - host.low().y);
  std::vector<Cut> cuts = level_cuts(host, height, DVec3(facing));
  double length = 0;
  for (const Cut& c : cuts) length += glm::distance(c.from, c.to);
  std::vector<Start> starts;
  if (!(length > 0)) return starts;
  std::size_t at = 0;
  double before = 0;
  for (int i = 0; i < count; ++i) {
    double jitter = seed.child("foot", static_cast<std::uint64_t>(i)).range(0.2, 0.8);
    double goal = (i + jitter) * length / count;
    while (at + 1 < cuts.size() && before + glm::distance(cuts[at].from, cuts[at].to) < goal)
      before += glm::distance(cuts[at].from, cuts[at].to), ++at;
    double own = glm::distance(cuts[at].from, cuts[at].to);
    double share = own > 0 ? std::clamp((goal - before) / own, 0.0, 1.0) : 0.5;
    starts.push_back({cuts[at].from + (cuts[at].to - cuts[at].from) * share, DVec3(0)});
  }
  return starts;
}

std::vector<Start> starts_around(const TriangleSurface& host, int count, Vec3 centre, double radius,
                                 Seed seed) {
  DiscreteDistribution lots;
  for (std::uint32_t t = 0; t < host.triangles().size(); ++t) {
    DVec3 a(host.triangles()[t][0]), b(host.triangles()[t][1]), c(host.triangles()[t][2]);
    DVec3 low = glm::min(glm::min(a, b), c), high = glm::max(glm::max(a, b), c);
    DVec3 nearest = glm::clamp(DVec3(centre), low, high);
    lots.add(glm::distance(nearest, DVec3(centre)) <= radius ? triangle_area(a, b, c) : 0);
  }
  std::vector<Start> starts;
  // Points of large triangles may lie outside: draw until there are enough.
  for (std::uint64_t draw = 0; starts.size() < static_cast<std::size_t>(std::max(count, 0)) &&
                               lots.sum() > 0 && draw < 64 * static_cast<std::uint64_t>(count);
       ++draw) {
    Seed own = seed.child("around", draw);
    const auto& [a, b, c] = host.triangles()[lots.drawn(own.child(0).unit())];
    DVec3 share = drawn_weights(own.child(1).unit(), own.child(2).unit());
    DVec3 p = DVec3(a) * share.x + DVec3(b) * share.y + DVec3(c) * share.z;
    if (glm::distance(p, DVec3(centre)) <= radius) starts.push_back({p, DVec3(0)});
  }
  return starts;
}

}  // namespace frond
