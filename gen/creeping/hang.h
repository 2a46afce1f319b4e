#pragma once

#include "creeping/host.h"

namespace frond {

/// A strand that has lost its hold: links of one length, held at their upper end only.
struct Chain {
  DVec3 root{0};                         ///< the last place that holds
  DVec3 heading{0, 1, 0};                ///< of length 1: how the strand comes out of it
  double link = 0.02;                    ///< metres
  double stiffness = 0.1;                ///< metres that it stands out before its own weight bends it down
  double lift = 0.003;                   ///< metres that it keeps off the host
  const GroundHeight* ground = nullptr;  ///< off which it keeps as well
  std::vector<DVec3> place;              ///< ends of the links
  std::vector<DVec3> curl;   ///< by which each link turns from the one before where it bears no weight
  std::vector<DVec3> load;   ///< what the host pushes each link's end with, in metres of strand
  std::vector<DVec3> clear;  ///< where room was measured last, for each
  std::vector<double> room;  ///< metres from there to the host and the ground, or less

  double length() const { return link * static_cast<double>(place.size()); }
};

/// Appends a link in a direction (of length 1), or beside it where the host is in the way. False, and nothing
/// is appended, where there is no room.
bool lengthen(Chain& chain, const Host& host, const DVec3& direction, const DVec3& curl = DVec3(0));

/// Lets weight and stiffness bend the chain, `sweeps` times over, and keeps it out of the host. Links keep
/// their length. Returns the farthest that any joint moved in the last sweep, as a share of a link. `calm`, 0
/// to 1, damps it: 0 is the fastest, toward 1 it comes to rest where it lies on edges.
///
/// The bending energy of a chain of equal links is a sum over neighbouring directions, its weight a sum over
/// single ones; so the best direction of a link between its neighbours is known, and taking it never raises
/// the energy: sweeps settle from any state, with any stiffness. What the host pushes out is remembered as a
/// load, as the multipliers of Uzawa's method are, so that a length that lies on a ledge is drawn by what
/// hangs over it.
double settle(Chain& chain, const Host& host, int sweeps, double calm = 0);

}  // namespace frond
