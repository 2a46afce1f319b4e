#include "organisms/tree_parts.h"

#include "organisms/describe_grammar.h"

namespace frond {

void describe(Properties& v, TreeGuide& g) {
  v.custom("points", g.points, read_guide_line, kGuideLineSchema,
           "A line of points [x, y, z] in metres from the foot, y up; {at, in, out} has handles of a Bézier "
           "curve, and one that forks is {at, children}, children being lines of points that start there");
  describe_line(v, g);
}

Result<GuideAxes> axes_of_guide(const TreeGuide& text) {
  GuideAxes axes;
  if (text.empty()) return axes;
  for (const GuidePoint& point : text.points)
    if (point.radius || point.angle || point.elasticity || point.tropism)
      return Error{"/points",
                   "a tree is led through places alone; expected points without radius, angle, "
                   "elasticity and tropism"};
  Result<Guide> guide = guide_of(text);
  if (!guide) return guide.errors();
  for (const GuidePoint& point : guide->points) axes.points.push_back({Vec3(point.at), point.parent});
  return axes;
}

Errors check_guide(const TreeGuide& guide) {
  Result<GuideAxes> axes = axes_of_guide(guide);
  if (axes) return {};
  Errors errors = axes.errors();
  for (Error& error : errors) error.where = "/guide" + error.where;
  return errors;
}

void describe(Properties& v, AlongParent& a) {
  v.curve(
      "angle_along", a.angle,
      "Factor of the angle between a branch, from its foot to its tip, and its parent, by the place on the "
      "parent, from 0 at its foot to 1 at its tip");
  v.curve("length_along", a.length,
          "Factor of the length, and of that of all it bears, by the place on the parent, as angle_along; no "
          "less than 0.05");
  v.curve(
      "radius_along", a.radius,
      "Factor of the radius by the place on the parent, as angle_along; no less than 0.05, and no branch is "
      "thicker than its parent there");
}

void describe(Properties& v, BranchesAlong& b) {
  v.object("branches", b.branches, "How the branches on the stem are shaped, once they have grown");
  v.object("twigs", b.twigs, "The same of those on the branches");
}

}  // namespace frond
