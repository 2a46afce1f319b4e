#pragma once

#include <vector>

#include "core/seed.h"
#include "land/plot.h"
#include "model/surface.h"

namespace frond {

/// Hilly land about the origin, and a path through it.
struct TerrainShape {
  double size = 160;      ///< metres, of the square that is sown
  double hills = 8;       ///< metres, from valley to top
  double hill_size = 70;  ///< metres from hill to hill
  double rough = 0.4;     ///< 0 rolling .. 1 broken
  PathShape path;
};

/// The land itself: a grid of lines, dense in the sown square and ever wider apart beyond it, to the horizon.
/// All answers are those of the mesh that is drawn. Quick: some ten million heights a second.
class Terrain {
 public:
  /// At the origin the land is 0 m high. From the lowest to the highest of the sown square, or of one of
  /// twice `hill_size` where that is larger, it rises by `hills`, within a tenth.
  Terrain(const TerrainShape& shape, Seed seed);

  /// Metres; beyond the mesh that of its rim.
  double height(double x, double z) const;
  /// Of length 1, smooth: between those of the grid's vertices.
  Vec3 normal(double x, double z) const;
  /// Radians from the level, by the normal.
  double slope(double x, double z) const;

  /// Metres to the edge of the path; below 0 on it. In the sown square the land is level across it.
  double path_distance(Vec2 at) const { return plot_.path_distance(at); }
  /// The path, without a pond.
  const Plot& plot() const { return plot_; }

  /// Metres from the origin to where the mesh ends, along x and z; at least 1200.
  double reach() const { return line_.back(); }

  Surface surface() const;

 private:
  struct Cell;
  Cell cell_at(double x, double z) const;
  std::size_t vertex(std::size_t column, std::size_t row) const { return row * line_.size() + column; }
  Vec3 vertex_normal(std::size_t column, std::size_t row) const;

  Plot plot_;
  std::vector<float> line_;    // where the grid's lines run, along x as along z
  std::vector<float> height_;  // of the vertices, row by row (z)
  std::vector<Vec3> normal_;
};

}  // namespace frond
