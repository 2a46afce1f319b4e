#pragma once

#include "creeping/triangle_surface.h"

namespace frond {

/// A hanging strand: links of equal length, held only at the upper end.
struct Chain {
  DVec3 root{0};                         ///< the last point that is held
  DVec3 heading{0, 1, 0};                ///< of length 1: direction of the strand there
  double link = 0.02;                    ///< metres
  double stiffness = 0.1;                ///< metres that it stands out before it bends under its own weight
  double lift = 0.003;                   ///< metres that it keeps from the host
  bool outside = false;                  ///< keeps out of what lies behind open parts, see backs_seen()
  const GroundHeight* ground = nullptr;  ///< from which it keeps the same distance
  std::vector<DVec3> place;              ///< ends of the links
  std::vector<DVec3> curl;               ///< turn of each link against the one before when it bears no weight
  std::vector<DVec3> load;               ///< push of the host on each link's end, in metres of strand
  std::vector<DVec3> clear;              ///< where free space was last measured, for each
  std::vector<double> room;              ///< metres from there to the host and the ground, or less

  double length() const { return link * static_cast<double>(place.size()); }
};

/// How much of what is seen from a place, of all directions, are backs of the host's open parts: in the plane
/// of a hole of a scan half, farther within it more, far behind an open sheet almost half.
struct BacksSeen {
  double share = 0;
  DVec3 out{0};  ///< of length 1: where fewest are
};
BacksSeen backs_seen(const TriangleSurface& host, const DVec3& place);
inline constexpr double kBehind = 0.4;  ///< the share from which a place lies behind

/// Appends a link in a direction (of length 1), or beside it where the host is in the way. False, with
/// nothing appended, where there is no room.
bool lengthen(Chain& chain, const TriangleSurface& host, const DVec3& direction,
              const DVec3& curl = DVec3(0));

/// Lets weight and stiffness bend the chain in `sweeps` passes and keeps it out of the host. Links keep their
/// length. Returns the farthest move of any joint in the last pass, as a share of a link. `calm`, 0 to 1,
/// damps it: 0 is fastest; values near 1 let it come to rest where it lies on edges.
///
/// The bending energy of a chain of equal links is a sum over neighbouring directions, its weight a sum over
/// single directions. So the best direction of a link between its neighbours is known, and taking it never
/// raises the energy: the passes converge from any state with any stiffness. Pushes of the host are kept as
/// loads, like the multipliers of Uzawa's method, so that a part that lies on a ledge is pulled by the part
/// that hangs over it.
double settle(Chain& chain, const TriangleSurface& host, int sweeps, double calm = 0);

}  // namespace frond
