#pragma once

#include <array>
#include <vector>

#include "core/seed.h"
#include "core/spline.h"
#include "core/vec.h"
#include "model/solid.h"

namespace frond {

/// A pond: an ellipse with an uneven shore.
struct PondShape {
  Vec2 center{0};        ///< x, z in metres
  Vec2 size{0};          ///< metres from the middle to the shore along x and z; 0: no pond
  double depth = 0.8;    ///< metres below the lawn
  double level = -0.07;  ///< of the water, metres above the lawn
};

/// A path through the garden: a smooth curve through points, with uneven edges.
struct PathShape {
  std::vector<SplinePoint<Vec2>> points;  ///< x, z in metres; fewer than two: no path
  double width = 1.2;                     ///< metres
};

/// A rectangle in a lawn, or what an outline encloses, with another ground.
struct GroundArea {
  enum class Kind { gravel, earth };
  Kind kind = Kind::gravel;
  Vec2 center{0}, size{1};                      ///< of the rectangle: x, z in metres
  std::vector<SplinePoint<Vec2>> outline = {};  ///< closed by itself; empty: the rectangle
  bool curve = false;  ///< whether the outline is smooth at points without handles, too

  /// The outline as a polygon; empty without an outline.
  std::vector<Vec2> corners() const;

  /// Two corners of the box that encloses the area: lowest and highest x and z, metres.
  std::array<Vec2, 2> box() const;
};

/// The ground plan of a garden.
class Plot {
 public:
  Plot() = default;
  Plot(const PondShape& pond, const PathShape& path, Seed seed, std::vector<GroundArea> areas = {});

  /// Approximate distance to the shore, metres; negative in the pond.
  double pond_distance(Vec2 at) const;
  /// Metres to the middle line of the path.
  double path_middle_distance(Vec2 at) const;
  /// Metres to the edge of the path or of an area of gravel, which is uneven; negative on it.
  double path_distance(Vec2 at) const;
  /// Metres to the edge of an area of earth, which is uneven; negative on it.
  double earth_distance(Vec2 at) const;

  /// The height of ground that was at height `lawn`: level round the pond and under the path, a basin in the
  /// pond, raised a little where it is earth.
  double height(Vec2 at, double lawn) const;

  const PondShape& pond() const { return pond_; }
  bool has_pond() const { return pond_.size.x > 0 && pond_.size.y > 0; }
  bool has_path() const { return path_.size() > 1 || has_area(GroundArea::Kind::gravel); }
  bool has_earth() const { return has_area(GroundArea::Kind::earth); }
  const std::vector<Vec2>& path() const { return path_; }
  const std::vector<GroundArea>& areas() const { return areas_; }

 private:
  bool has_area(GroundArea::Kind kind) const;
  double area_distance(Vec2 at, GroundArea::Kind kind) const;
  double curve_distance(Vec2 at) const;  // to the edge of the path

  PondShape pond_;
  double half_width_ = 0;
  std::vector<Vec2> path_;  // the middle line as short segments
  std::vector<GroundArea> areas_;
  std::vector<std::vector<Vec2>> outlines_;  // of these, as polygons
  Seed seed_;
};

/// Up to `count` leaves of water lilies, some with a flower, floating on the pond in a few groups.
Solids water_lilies(const Plot& plot, int count, Seed seed);

/// Gravel on a square of `side` metres about the origin: stones of about `size` metres, half buried. `uv`: v
/// is a random number per stone.
Surface gravel_surface(double side, double size, Seed seed);

}  // namespace frond
