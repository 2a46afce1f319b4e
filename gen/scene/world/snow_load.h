#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/curve.h"
#include "core/seed.h"
#include "core/vec.h"

namespace frond {

/// The snow on the branches of a specimen.
struct SnowLoad {
  Animated<double> depth;           ///< metres, on open level ground
  std::vector<float> share;         ///< of each node, of what a level branch of its thickness carries
  std::vector<std::int32_t> bough;  ///< of each node, what drops its snow as one
  std::vector<float> drops;         ///< of each bough, when that is: seconds; infinity: never
  Seed powder{};                    ///< of what then hangs in the air

  /// What is left at a node at a time, 0..1.
  float left(std::size_t node, double time) const {
    constexpr float kTakes = 0.4f;  // seconds
    float since = static_cast<float>(time) - drops[static_cast<std::size_t>(bough[node])];
    return 1 - smooth_step(0.0f, kTakes, since);
  }
};

/// Height of the snow on what is so broad, metres: half as much again as its breadth where that is small, as
/// snow holds together, and no more than lies on the ground.
inline double heap_height(double depth, double breadth) {
  return depth > 0 ? depth * (1 - std::exp(-1.5 * breadth / depth)) : 0;
}

}  // namespace frond
