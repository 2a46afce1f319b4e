#pragma once

#include "creeping/host.h"

namespace frond {

/// Where the tip of a strand stands on a host and where it heads.
struct Tread {
  DVec3 place{0};              ///< the lift off the surface
  DVec3 contact{0};            ///< on the surface, below `place`
  DVec3 normal{0, 1, 0};       ///< of length 1, away from the surface on the side of the strand
  DVec3 heading{1, 0, 0};      ///< of length 1, at right angles to `normal`
  std::uint32_t triangle = 0;  ///< of `contact`
};

/// A direction laid into the plane that is tangent at `normal`: N x (v x N), of length 1. Along the normal
/// itself, some direction of that plane.
DVec3 tangent(const DVec3& direction, const DVec3& normal);

/// A heading turned about the normal (radians; positive to the left seen from outside): of the same length,
/// and tangent as before.
DVec3 turned(const DVec3& heading, const DVec3& normal, double angle);

/// A heading turned toward a direction (of any length) by a share 0..1 of the shortest arc between them, and
/// laid back into the tangent plane. 0 leaves it, 1 gives the direction itself, tangent. Where the
/// direction is straight behind, the turn is about the normal.
DVec3 leaning(const DVec3& heading, const DVec3& normal, const DVec3& direction, double share);

/// How a stride went.
enum class Footing {
  held,   ///< on the surface
  edge,   ///< on the surface, round a convex edge of more than 30 degrees
  stuck,  ///< no way on, however short
};

struct Stride {
  Tread tread;        ///< after it
  double length = 0;  ///< that was walked, metres
  Footing footing = Footing::held;
};

/// One stride over the surface, of at most `length` metres, straight ahead and `lift` metres off it: the step
/// in the tangent plane, then back to the lift above the closest point. The normal is the direction from that
/// point, which is continuous round convex edges (with the normal of the face no strand gets over one); the
/// heading is carried along by the shortest turn between the normals, so that a strand that runs head-on into
/// a wall climbs it. A stride ends early at a wall, and is halved as long as its chord would cut through the
/// surface deeper than 0.7 `lift`.
Stride stride(const Host& host, const Tread& from, double length, double lift);

/// A tread at the surface point that is nearest to a place, or nothing where that is farther than `within`.
/// The side is that of the place, where it is off the surface by more than a hundredth of the lift; else the
/// outer one. A heading of length 0 is replaced by the steepest way up.
std::optional<Tread> tread_at(const Host& host, const DVec3& place, const DVec3& heading, double lift,
                              double within = std::numeric_limits<double>::infinity());

}  // namespace frond
