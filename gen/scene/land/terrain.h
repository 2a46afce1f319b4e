#pragma once

#include <vector>

#include "core/seed.h"
#include "land/plot.h"
#include "land/stream.h"
#include "model/surface.h"

namespace frond {

/// Hilly land about the origin with a path through it.
struct TerrainShape {
  double size = 160;      ///< metres, side of the sown square
  double hills = 8;       ///< metres, from valley to top
  double hill_size = 70;  ///< metres from hill to hill
  double rough = 0.4;     ///< 0 rolling .. 1 broken
  double erosion = 0;     ///< 0 none .. 1 spurs and gullies of high mountains: eroded_hill_noise()
  PathShape path;
  StreamShape stream{};
};

/// The land: a grid of lines, dense in the sown square and increasingly sparse beyond it to the horizon. All
/// answers are those of the drawn mesh. Fast: about ten million heights a second.
class Terrain {
 public:
  /// The height at the origin is 0 m. The height range of the sown square, or of a square of twice
  /// `hill_size` if that is larger, is `hills` within a tenth.
  Terrain(const TerrainShape& shape, Seed seed);

  /// The height of the land, metres; beyond the mesh the height of its rim.
  double height(double x, double z) const;

  /// Metres to the edge of the path; negative on it. In the sown square the land is level across the path.
  double path_distance(Vec2 at) const { return plot_.path_distance(at); }
  /// The path, without a pond.
  const Plot& plot() const { return plot_; }
  /// The stream; below its bed the mesh is lower than that.
  const StreamCourse& stream() const { return stream_; }

  /// Metres from the origin to the end of the mesh, along x and z; at least 1200.
  double reach() const { return line_.back(); }

  Surface surface() const;

 private:
  std::size_t vertex(std::size_t column, std::size_t row) const { return row * line_.size() + column; }
  /// Smooth, of length 1.
  Vec3 normal(std::size_t column, std::size_t row) const;

  Plot plot_;
  StreamCourse stream_;
  std::vector<float> line_;    // positions of the grid's lines, along both x and z
  std::vector<float> height_;  // of the vertices, row by row (z)
};

}  // namespace frond
