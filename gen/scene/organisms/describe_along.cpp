#include "organisms/describe_along.h"

namespace frond {

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
