#pragma once

#include "core/curve.h"
#include "model/skeleton.h"

namespace frond {

/// How the thickness of branches is set.
enum class GirthFrom {
  turtle,    ///< the turtle's widths
  distance,  ///< the distance to the farthest tip, through a curve
  pipe       ///< the load above: r^n = sum of r_i^n (Leonardo's rule; the pipe model)
};

struct Girth {
  GirthFrom from = GirthFrom::turtle;
  double radius = 0;                  ///< metres, at the base; 0: that of the turtle
  double exponent = 2.3;              ///< n of the pipe model
  Curve curve{{{0, 0.15f}, {1, 1}}};  ///< for `distance`: from 0 at the farthest tip to 1 at the base
  double least = 0.0005;              ///< metres, the minimum radius
  double flare = 0;                   ///< how much wider the foot is
};

/// Sets the radii of a skeleton whose `radius` holds half of the turtle's widths, and whose `to_tip` is set.
/// With `sprouting`, a tip that is short relative to its branch counts for less in the pipe model.
void set_girth(Skeleton& skeleton, const Girth& girth, float start_radius, bool sprouting = false);

}  // namespace frond
