#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// Lines that the first axes of a tree are led along: a tree of points, parents before children, the foot of
/// the tree at the origin. Metres.
struct GuideAxes {
  struct Point {
    static constexpr std::int32_t kFoot = -1;
    Vec3 at{0};
    std::int32_t parent = kFoot;  ///< the point before it
  };
  std::vector<Point> points;

  bool empty() const { return points.empty(); }
};

/// One line of guides, from the foot or from a fork to an end.
struct GuideAxis {
  std::vector<Vec3> at;            ///< the first is the foot, or the fork
  double from = 0;                 ///< metres along the axes from the foot to its first point
  std::int32_t off = -1;           ///< the axis that it forks off, -1 for the first
  double length() const;           ///< metres
  Vec3 point(double along) const;  ///< so many metres from its first point
};

/// The axes of guides. At each fork the axis goes on along the longest way, as a leader does, and the others
/// begin there. An axis comes before those that fork off it. Points that lie on each other count once.
std::vector<GuideAxis> axes_of(const GuideAxes& guides);

}  // namespace frond
