#pragma once

#include "core/result.h"
#include "core/seed.h"
#include "crown/crown.h"
#include "crown/envelope.h"

namespace frond {

/// Growth into free space (Runions, Lane and Prusinkiewicz 2007, *Modeling Trees with a Space Colonization
/// Algorithm*): points of an envelope attract the nearest branch and are gone when it comes near. Metres.
struct Colonization {
  int attractors = 6000;    ///< points in the envelope
  double influence = 2;     ///< farther than this a point attracts nothing
  double kill = 0.25;       ///< nearer than this a point is taken
  double step = 0.12;       ///< length of a segment
  double tropism = 0;       ///< upward pull, as a share of that of the points; negative: downward
  double jitter = 0.1;      ///< random part of each direction
  double crowding = 0;      ///< -1 more points inside .. 1 more points at the rim
  int most_nodes = 400000;  ///< where growth ends in any case
};

/// Grows one tree from the origin: first straight up or toward the envelope until its points are in reach.
/// Every node above that stem lies inside of the envelope, or within one step of it; points closer than
/// `kill` to the finished tree are taken, and what is left is farther than `influence` or was given up
/// because nothing came nearer to it. The radii are 1: they are for the pipe model to set.
Result<Skeleton> colonize(const Envelope& envelope, const Colonization& how, Seed seed);

/// Leaves at the ends of branches: `spacing` metres apart along what is no farther than `reach` from a tip,
/// by the golden angle, `down` from the branch.
std::vector<LeafSite> dress_tips(const Skeleton& skeleton, double reach, double spacing, double down,
                                 Seed seed);

}  // namespace frond
