#pragma once

#include <array>
#include <vector>

#include "core/vec.h"

namespace frond {

/// How much of what comes from outside is held up in a box: cells of one size and coarser ones over them, by
/// which wide cones are followed in few steps (Crassin et al. 2011). Sums of whole numbers, so that the order
/// in which it is filled makes no difference.
class Openness {
 public:
  Openness(Vec3 low, Vec3 high, float cell);

  void clear();
  /// `area` of a skin at a place, square metres.
  void add(Vec3 at, float area);
  /// After all was added.
  void build();

  /// What share of it comes to a place of the skin with that normal: of all that comes in the open to what
  /// faces up. `light` is the share that comes from above, see Accretion.
  float openness(Vec3 at, Vec3 normal, float light) const;

 private:
  struct Level {
    std::array<int, 3> count;
    float cell;
    std::vector<float> held;     // 0 nothing .. 1 all
    std::vector<char> anything;  // whether one of the eight cells from each on holds something
  };
  static void mark(Level& level);
  static float held_at(const Level& level, Vec3 at);

  Vec3 low_;
  std::vector<std::int32_t> area_;  // of the finest cells, in 1/256 of a cell's face
  std::vector<Level> levels_;
};

}  // namespace frond
