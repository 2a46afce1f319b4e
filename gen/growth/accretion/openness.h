#pragma once

#include <vector>

#include "core/vec.h"

namespace frond {

/// How much of the light and food from outside is blocked in a box: cells of one size and coarser levels over
/// them, through which wide cones are traced in few steps (Crassin et al. 2011). Sums are integers, so that
/// the order of filling makes no difference.
class Openness {
 public:
  Openness(Vec3 low, Vec3 high, float cell);

  void clear();
  /// Adds `area` square metres of skin at a point.
  void add(Vec3 at, float area);
  /// To be called once everything is added.
  void build();

  /// The share of it that reaches a point of the skin with that normal, relative to an open surface that
  /// faces up. `light` is the share that comes from above, see Accretion.
  float openness(Vec3 at, Vec3 normal, float light) const;

 private:
  struct Level {
    glm::ivec3 count;
    float cell;
    std::vector<float> held;     // 0 nothing .. 1 all
    std::vector<char> anything;  // whether any of the eight cells from each one on is not empty

    std::size_t at(int x, int y, int z) const {
      return static_cast<std::size_t>((z * count.y + y) * count.x + x);
    }
  };
  static void mark(Level& level);
  static float held_at(const Level& level, Vec3 at);

  Vec3 low_;
  std::vector<std::int32_t> area_;  // of the finest cells, in 1/256 of a cell's face
  std::vector<Level> levels_;
};

}  // namespace frond
