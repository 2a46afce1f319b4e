#pragma once

#include <vector>

#include "foliage/inflorescence.h"

// The flowers of an inflorescence while they make room for each other.

namespace frond {

/// A flower on its stalk.
struct CrowdFloret {
  Vec3 foot{0};                      ///< of its stalk
  Vec3 rest{0, 1, 0}, way{0, 1, 0};  ///< directions of the stalk, of length 1: wanted, and as it is
  double stalk = 0;                  ///< its length, not less than it was at first
  double nod = 0;                    ///< angle by which the flower is turned down from the stalk
  OrganRoom room;                    ///< scaled

  Vec3 tip() const { return foot + way * static_cast<float>(stalk); }
};

/// The heading of a flower on a stalk.
Vec3 heading_of(const CrowdFloret& floret, Vec3 down);

/// The distance between two segments, and where on both they are nearest.
struct SegmentsGap {
  float distance;
  Vec3 on_first, on_second;
};
SegmentsGap gap_between(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

/// Turns stalks and stretches them until no rooms overlap, or for a number of rounds.
void make_room(std::vector<CrowdFloret>& florets, Vec3 down);

}  // namespace frond
