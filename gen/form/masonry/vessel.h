#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// A vase, bowl or pot turned about the y axis. Metres, or any unit of `profile` if `height` scales it.
struct VesselShape {
  /// Control points of a Bézier curve of degree 1 to 20, (radius, height) from the foot to the lip: the
  /// outside.
  std::vector<glm::dvec2> profile{{0.05, 0}, {0.16, 0.08}, {0.12, 0.22}, {0.03, 0.26}, {0.07, 0.32}};
  double height = 0;    ///< height to which the curve is scaled, without foot and lip; 0: not scaled
  double wall = 0.006;  ///< thickness; the inside is the exact offset of the outside
  double lip = 1.3;     ///< thickness of the rounded lip as a multiple of the wall's, at least 1
  double foot = 0.006;  ///< height of the ring it stands on
  double foot_radius =
      0;           ///< outer radius of the ring; 0: that of the curve's foot, or a third of its widest
  int sides = 96;  ///< of the mesh, round it, at least 3
  int rings = 96;  ///< of the mesh, along the curve, at least 24
};

/// A cross-section of a vessel, to be turned about the axis.
struct VesselProfile {
  /// (radius, y) from the axis under the foot, up the outside, over the lip and down the inside to the axis;
  /// it stands on y = 0. Does not cross itself.
  std::vector<glm::dvec2> outline;
  std::vector<double> along;  ///< of each point: 0 foot .. 1 lip outside, 1 .. 2 down the inside, by height
  std::vector<double> curve;  ///< of each point: its parameter if it is on the given curve, else -1
  std::size_t inside = 0;     ///< index of the first point of the inside
  double wall = 0;            ///< actual thickness
  double floor = 0;           ///< y of the inside's lowest point
  double rim = 0;             ///< y of the lip's highest point
  std::string note;           ///< why the wall is thinner than asked; empty if it is not
};

/// Makes the profile. A wall thicker than 0.95 of the curve's smallest radius of curvature toward the inside,
/// or than a neck is wide, is made thinner, and `note` says so. Refuses profiles with fewer than 2 or more
/// than 21 points, with negative radii, closed at the top, below their foot or crossing themselves.
Result<VesselProfile> vessel_profile(const VesselShape& shape);

/// The vessel as a closed mesh; `uv` is (turn, 0..1; `along`). Vertices of the seam are duplicated.
Surface vessel_surface(const VesselProfile& profile, int sides);

/// Cubic Bézier spans, (radius, y), that follow the outline from axis to axis, for renderers with surfaces of
/// revolution. A curve of degree 3 or less is one exact span; others are within `tolerance` metres.
std::vector<std::array<glm::dvec2, 4>> vessel_spans(const VesselShape& shape, const VesselProfile& profile,
                                                    double tolerance);

/// Earth that fills the inside to `share` of its height (0..1), slightly heaped and lumpy, as a closed mesh
/// that reaches into the wall by a third of it; and the height of its middle.
struct Soil {
  Surface surface;
  double height = 0;
};
Soil vessel_soil(const VesselProfile& profile, double share, int sides, Seed seed);

}  // namespace frond
