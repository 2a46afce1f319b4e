#pragma once

#include <vector>

#include "core/vec.h"
#include "world/world.h"

namespace frond {

/// How far it is to what stands, at any place in a box. A grid of exact distances between its cells
/// (Felzenszwalb and Huttenlocher 2012), so it costs nothing to ask.
class Clearance {
 public:
  /// An open box, with cells of that size.
  Clearance(Vec3 low, Vec3 high, float cell);

  /// Takes in a ball; what is outside of the box is passed over.
  void take(Vec3 middle, float radius);
  /// The same of a cone between two balls, and of a mesh.
  void take(Vec3 a, Vec3 b, float radius_a, float radius_b);
  void take(const Surface& surface);
  /// All that is below the ground.
  void take_ground(const World& world);
  /// Works the distances out; needed before they are asked for, once all is taken in.
  void measure();

  /// Metres to what stands, at most about the size of the box; beyond the box as at its edge.
  float operator()(Vec3 at) const;
  /// The direction away from it, not of length 1; 0 where there is none.
  Vec3 away(Vec3 at) const;

  Vec3 low() const { return low_; }
  Vec3 high() const { return low_ + cell_ * Vec3(size_[0], size_[1], size_[2]); }

 private:
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size_[0]) +
           static_cast<std::size_t>(x);
  }

  Vec3 low_;
  float cell_;
  int size_[3];
  std::vector<float> distance_;  // cells, squared until they are measured
};

/// The clearance of all that stands in a world, throughout the film, round a home.
Clearance clearance_of(const World& world, Vec3 low, Vec3 high, float cell);

}  // namespace frond
