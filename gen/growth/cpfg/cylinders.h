#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/vec.h"
#include "cpfg/curves.h"
#include "model/surface.h"

// Generalized cylinders: a contour that is carried along a curve through control places.

namespace frond::cpfg {

/// A vector of length 1, or 0 where it has no direction.
inline DVec3 unit(DVec3 v) {
  double length = std::sqrt(glm::dot(v, v));
  return length > 0 && std::isfinite(length) ? v / length : DVec3{0, 0, 0};
}

/// Turns a vector about an axis of length 1, right-handed.
inline DVec3 turned(DVec3 v, DVec3 axis, double angle) {
  double c = std::cos(angle), s = std::sin(angle);
  return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

/// How the turtle stands, and draws cylinders.
struct CylinderState {
  DVec3 position{0}, heading{0, 1, 0}, left{-1, 0, 0}, up{0, 0, -1};
  int contour = 0;                       ///< its number; 0: a circle
  double arriving = 1.2, leaving = 1.2;  ///< `@Gt`: lengths of tangents, as shares of the distance
  /// `@Gr`: tangents of the radius's own curve, along and out; both 0: the radius changes evenly.
  std::array<double, 2> rise_arriving{}, rise_leaving{};
  /// What is out is multiplied with the distance, for the piece that ends here.
  bool rises_by_length = false;
  int color = 0;
  std::int32_t segment = -1;  ///< that ends here, see figure.cpp
};

/// A place that a cylinder goes through, as the turtle stood there.
struct ControlPlace : CylinderState {
  double radius = 0.5;
  int sides = 8;
  int strips = 0;  ///< of the piece that ends here; 0: as many as others
};

/// The contour at a place of the curve: `share` of the way from one to the other.
struct CylinderRing {
  DVec3 position, heading, left, up;
  double radius;
  int from, to;  ///< contours
  double share;
  int color;
};

/// The rings of a piece between two places, both ends included, along Hermite's curve. The frame of the first
/// place is carried without twist; with `twisted` it is rolled evenly to that of the second.
std::vector<CylinderRing> piece_rings(const ControlPlace& from, const ControlPlace& to, int strips,
                                      bool twisted);

/// The rings along an even cubic B-spline that the places lead. An open one begins near the second place and
/// ends near the last but one. Empty where there are too few places: 4, or 3 of a closed one.
std::vector<CylinderRing> spline_rings(std::span<const ControlPlace> places, bool closed, int strips);

/// Whether all rings are circles, so that a cylinder is a branch.
bool is_round(std::span<const CylinderRing> rings, const std::map<int, CurveTable>& contours);

/// The skin of a row of rings, with `uv` along and across it.
Surface skin_of(std::span<const CylinderRing> rings, const std::map<int, CurveTable>& contours, int sides);

}  // namespace frond::cpfg
