#pragma once

#include "images/leaf.h"

// What the picture and the mesh of a leaf share.

namespace frond {

/// How a blade lies in the unit of its leaf: where on the stalk's line the middle of its circle is, and what
/// a radius of 1 is there.
struct LeafFrame {
  double middle, scale;
};
LeafFrame leaf_frame(const LeafOutline& outline);

/// Radius of the blade at an angle from the tip, -pi..pi, in the outline's own unit.
double leaf_radius(const LeafOutline& outline, double angle);

}  // namespace frond
