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

/// A round mesh of the ground.
struct GroundDisc {
  double radius = 0;
  int rings = 2;      ///< within the radius, at least 2: fine in the middle, coarse toward it
  double beyond = 0;  ///< metres from the middle to which more of them follow, each as much wider than the
                      ///< last; less than the radius: none

  /// This disc enlarged so that it reaches `reach` metres: with more rings in proportion, up to `most`
  /// metres, so that what is near stays as fine; beyond that by few more, however far it is.
  GroundDisc reaching(double reach, double most) const;
};

/// The floor as a round mesh about `centre` (x, z). The relief fades out toward its edge.
Surface ground_surface(const Ground& ground, Vec2 centre, const GroundDisc& disc);

/// A ground of any `height` at (x, z) as a round mesh about `centre` (x, z); its relief does not fade out.
Surface ground_surface(const std::function<double(Vec2)>& height, Vec2 centre, const GroundDisc& disc);

/// Heights of a mesh without overhangs. As fast far from the origin as near it.
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
  // Triangles that touch each square, row by row: those of the finest grid, about the origin; and those of
  // the grids round it, one after the other, each of wider squares, until all of the mesh is within
  std::array<std::vector<std::vector<std::uint32_t>>, 2> cells_;
};

}  // namespace frond
