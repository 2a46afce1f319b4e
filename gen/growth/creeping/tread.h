#pragma once

#include "creeping/triangle_surface.h"

namespace frond {

/// Position and heading of the tip of a strand on a host.
struct Tread {
  DVec3 place{0};              ///< above the surface by the lift
  DVec3 contact{0};            ///< on the surface, below `place`
  DVec3 normal{0, 1, 0};       ///< of length 1, away from the surface on the side of the strand
  DVec3 heading{1, 0, 0};      ///< of length 1, at right angles to `normal`
  std::uint32_t triangle = 0;  ///< of `contact`
};

/// A direction projected to the tangent plane of `normal`: N x (v x N), of length 1. For a direction along
/// the normal, some direction of that plane.
DVec3 tangent(const DVec3& direction, const DVec3& normal);

/// A tangent heading rotated about the normal (radians; positive to the left seen from outside), as long.
DVec3 turned(const DVec3& heading, const DVec3& normal, double angle);

/// A heading turned toward a direction (of any length) by a share 0..1 of the shortest arc between them,
/// projected back to the tangent plane. 0 leaves it, 1 gives the projected direction. If the direction is
/// straight behind, the turn is about the normal.
DVec3 leaning(const DVec3& heading, const DVec3& normal, const DVec3& direction, double share);

/// The outcome of a stride.
enum class Footing {
  held,   ///< on the surface
  edge,   ///< on the surface, round a convex edge of more than 30 degrees
  stuck,  ///< no step possible, however short
};

struct Stride {
  Tread tread;        ///< after the stride
  double length = 0;  ///< metres walked
  Footing footing = Footing::held;
};

/// One stride over the surface, at most `length` metres straight ahead and `lift` metres off it: a step in
/// the tangent plane, then back to the lift above the closest point. The normal is the direction from that
/// point, which is continuous round convex edges (with the face normal no strand gets over one). The heading
/// is transported by the shortest rotation between the normals, so that a strand that meets a wall head-on
/// climbs it. A stride ends early at a wall, and is halved while its chord would cut deeper than 0.7 `lift`
/// into the surface.
Stride stride(const TriangleSurface& host, const Tread& from, double length, double lift);

/// A tread at the surface point nearest to a place, or nothing where that is farther than `within`. Its side
/// is that of the place if the place is off the surface by more than a hundredth of the lift, else the outer
/// side. A heading of length 0 becomes steepest upward.
std::optional<Tread> tread_at(const TriangleSurface& host, const DVec3& place, const DVec3& heading,
                              double lift, double within = std::numeric_limits<double>::infinity());

}  // namespace frond
