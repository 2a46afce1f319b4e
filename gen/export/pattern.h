#pragma once

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "core/linear.h"
#include "core/seed.h"
#include "images/tiling_noise.h"

namespace frond {

inline DVec3 light_of(const Color& color) { return DVec3(linear(color)); }

/// A colour between those that stand at given places; beyond the ends that of the end.
inline DVec3 ramp(double x, std::initializer_list<std::pair<double, DVec3>> stops) {
  const std::pair<double, DVec3>* before = stops.begin();
  for (const auto& stop : stops) {
    if (x < stop.first) {
      double way = stop.first - before->first;
      return way > 0 ? glm::mix(before->second, stop.second, std::clamp((x - before->first) / way, 0.0, 1.0))
                     : stop.second;
    }
    before = &stop;
  }
  return before->second;
}

/// Noises of a picture that fits on itself, (u, v) being 0..1; `which` tells them apart.
struct Pattern {
  Seed seed;

  /// Features `count` of which are across the picture; about -1..1.
  double fractal(double u, double v, int count, int octaves, std::uint64_t which) const {
    return tiling_fractal(u * count, v * count, count, count, octaves, 0.55, seed.child(which));
  }
  /// With other numbers of them across and along.
  double drawn_out(double u, double v, int across, int along, int octaves, std::uint64_t which) const {
    return tiling_fractal(u * across, v * along, across, along, octaves, 0.55, seed.child(which));
  }
  /// Speckled, about 0..1 with a mean of a half, as POV-Ray's `granite` is.
  double granite(double u, double v, int count, std::uint64_t which) const {
    return std::clamp(0.5 + 0.75 * fractal(u, v, count, 6, which), 0.0, 1.0);
  }
  /// Soft blotches, about 0..1, as its `bozo`.
  double bozo(double u, double v, int count, std::uint64_t which) const {
    return std::clamp(0.5 + 0.6 * fractal(u, v, count, 3, which), 0.0, 1.0);
  }
};

}  // namespace frond
