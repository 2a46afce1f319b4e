#include "geometry/ground.h"

#include <cassert>
#include <cmath>

#include "core/noise.h"

namespace frond {

double ground_height(const Ground& ground, double x, double z) {
  Vec3 shift(static_cast<float>(ground.seed.child("x").range(-99, 99)), 0,
             static_cast<float>(ground.seed.child("z").range(-99, 99)));
  Vec3 p(static_cast<float>(x / ground.scale), 0, static_cast<float>(z / ground.scale));
  return 0.7 * ground.relief * fractal_noise(p + shift, 3);
}

Surface ground_surface(const Ground& ground, Vec2 centre, double radius, int rings) {
  assert(rings >= 2);
  Surface surface;
  int sectors = rings * 2;
  auto height = [&](Vec2 at, double distance) {
    return ground_height(ground, at.x, at.y) * (1 - smooth_step(0.6, 1.0, distance / radius));
  };
  surface.position.push_back(Vec3(centre.x, height(centre, 0), centre.y));
  for (int ring = 1; ring <= rings; ++ring) {
    double share = static_cast<double>(ring) / rings;
    double distance = radius * share * share;
    for (int sector = 0; sector < sectors; ++sector) {
      double angle = 2 * kPi * (sector + 0.5 * (ring % 2)) / sectors;
      Vec2 at = centre + Vec2(static_cast<float>(distance * std::cos(angle)),
                              static_cast<float>(distance * std::sin(angle)));
      surface.position.push_back(Vec3(at.x, height(at, distance), at.y));
    }
  }
  auto vertex = [&](int ring, int sector) {
    return ring == 0 ? 0u
                     : static_cast<std::uint32_t>(1 + (ring - 1) * sectors + (sector + sectors) % sectors);
  };
  for (int sector = 0; sector < sectors; ++sector)
    surface.triangle.push_back({vertex(0, 0), vertex(1, sector + 1), vertex(1, sector)});
  for (int ring = 1; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      // Odd rings are turned by half a sector, so that triangles stay near equilateral.
      int shift = ring % 2;
      auto a = vertex(ring, sector), b = vertex(ring, sector + 1);
      auto c = vertex(ring + 1, sector + shift), d = vertex(ring + 1, sector + shift + 1);
      if (shift) {
        surface.triangle.push_back({a, b, c});
        surface.triangle.push_back({b, d, c});
      } else {
        surface.triangle.push_back({a, d, c});
        surface.triangle.push_back({a, b, d});
      }
    }
  }
  set_normals(surface);
  return surface;
}

}  // namespace frond
