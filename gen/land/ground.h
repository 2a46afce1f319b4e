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
  double relief = 0.15;  ///< metres, amplitude of the dunes above and below the mean
  double scale = 3;      ///< metres from dune to dune, > 0
};

/// Height of the floor at (x, z).
double ground_height(const Ground& ground, double x, double z);

/// The floor as a round mesh about `centre` (x, z): fine in the middle, coarse toward `radius`, where the
/// relief fades out. `rings` (at least 2) sets the resolution.
Surface ground_surface(const Ground& ground, Vec2 centre, double radius, int rings);

/// The same for any ground with `height` at (x, z).
Surface ground_surface(const std::function<double(Vec2)>& height, Vec2 centre, double radius, int rings);

/// Heights of a mesh without overhangs: fast within 256 m of the origin, slow beyond.
class Heights {
 public:
  Heights() = default;
  explicit Heights(const Surface& surface);
  /// From a mesh that has its own faster height function.
  explicit Heights(std::function<double(double, double)> height) : known_(std::move(height)) {}

  /// At (x, z); 0 outside the mesh.
  double operator()(double x, double z) const;

  std::size_t bytes() const;  ///< of memory, about

 private:
  std::function<double(double, double)> known_;
  std::vector<std::array<Vec3, 3>> triangles_;
  // Triangles that touch each square, row by row: squares of 1 m about the origin, and of 8 m farther out
  std::array<std::vector<std::vector<std::uint32_t>>, 2> cells_;
};

}  // namespace frond
