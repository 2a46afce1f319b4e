#pragma once

#include <vector>

#include "core/vec.h"
#include "world/world.h"

namespace frond {

/// The distance to existing objects, at any point in a box. A grid of exact distances between its cells
/// (Felzenszwalb and Huttenlocher 2012), so a query is cheap.
class Clearance {
 public:
  /// An empty box with cells of that size.
  Clearance(Vec3 low, Vec3 high, float cell);

  /// Adds a ball; parts outside the box are ignored.
  void add(Vec3 middle, float radius);
  /// Adds a cone between two balls, or a mesh; parts outside the box are ignored.
  void add(Vec3 a, Vec3 b, float radius_a, float radius_b);
  void add(const Surface& surface);
  /// Adds everything below the ground.
  void add_ground(const World& world);
  /// Computes the distances; call it after all objects are added, before any query.
  void measure();

  /// Metres to the nearest object, at most about the size of the box; beyond the box as at its edge.
  float operator()(Vec3 at) const;
  /// The direction away from the nearest object, not normalized; 0 if there is none.
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

/// The clearance of everything in a world, throughout the film, round a home.
Clearance clearance_of(const World& world, Vec3 low, Vec3 high, float cell);

}  // namespace frond
