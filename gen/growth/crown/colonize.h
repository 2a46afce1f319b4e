#pragma once

#include "core/detour.h"
#include "core/result.h"
#include "core/seed.h"
#include "crown/axes.h"
#include "crown/crown.h"
#include "crown/envelope.h"

namespace frond {

/// Growth into free space (Runions, Lane and Prusinkiewicz 2007, *Modeling Trees with a Space Colonization
/// Algorithm*): points of an envelope attract the nearest branch and are removed when it comes near. Metres.
struct Colonization {
  int attractors = 6000;    ///< points in the envelope
  double influence = 2;     ///< a point attracts nothing farther away than this
  double kill = 0.25;       ///< a point is removed when a branch is nearer than this
  double step = 0.12;       ///< length of a segment
  double tropism = 0;       ///< upward pull, as a share of that of the points; negative: downward
  double jitter = 0.1;      ///< random part of each direction
  double crowding = 0;      ///< -1 more points inside .. 1 more points at the rim
  int most_nodes = 400000;  ///< growth stops at this number in any case
  Detour detour = {};       ///< what segments bend round, half a step away, and points do not attract through
};

/// Grows one tree from the origin: first straight up or toward the envelope until its points are within
/// reach. Every node above that stem is inside the envelope or within one step of it. Points closer than
/// `kill` to the finished tree are removed; a remaining point is farther than `influence`, or was given up
/// because no branch came nearer. All radii are 1; the pipe model sets them later. With guides the stem is
/// their axes, in the envelope or not, and growth goes on from all of these.
Result<Skeleton> colonize(const Envelope& envelope, const Colonization& how, Seed seed,
                          const GuideAxes& guides = {});

/// Leaves at the ends of branches: every `spacing` metres within `reach` of a tip, turned by the golden
/// angle, at angle `down` from the branch.
std::vector<LeafSite> leaf_sites_near_tips(const Skeleton& skeleton, double reach, double spacing,
                                           double down, Seed seed);

}  // namespace frond
