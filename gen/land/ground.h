#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// A floor of low dunes, level on average at y = 0.
struct Ground {
  Seed seed;
  double relief = 0.15;  ///< metres, the height of the dunes above and below the level
  double scale = 3;      ///< metres from dune to dune, > 0
};

/// How high the floor lies at (x, z).
double ground_height(const Ground& ground, double x, double z);

/// The floor as a round mesh about `centre` (x, z): fine in the middle, coarse toward `radius`, where the
/// relief is gone. `rings` (at least 2) sets how fine.
Surface ground_surface(const Ground& ground, Vec2 centre, double radius, int rings);

/// The same for any ground that is `height` high at a place (x, z).
Surface ground_surface(const std::function<double(Vec2)>& height, Vec2 centre, double radius, int rings);

/// How high a mesh without overhangs lies: quick to ask within 256 m of the origin, slow beyond.
class Heights {
 public:
  Heights() = default;
  explicit Heights(const Surface& surface);
  /// Those of a mesh that knows them by itself, and faster.
  explicit Heights(std::function<double(double, double)> height) : known_(std::move(height)) {}

  /// At (x, z); 0 beside the mesh.
  double operator()(double x, double z) const;

  std::size_t bytes() const;  ///< of memory, about

 private:
  std::function<double(double, double)> known_;
  std::vector<std::array<Vec3, 3>> triangles_;
  // Which triangles touch a square, row by row: of 1 m about the origin, and of 8 m farther out.
  std::array<std::vector<std::vector<std::uint32_t>>, 2> cells_;
};

}  // namespace frond
