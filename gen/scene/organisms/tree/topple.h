#pragma once

#include "grove/standing.h"
#include "model/model.h"
#include "motion/fall.h"

namespace frond {

/// How far the root plate of an uprooted tree reaches from the stem, in radii of the stem's foot. Wind-thrown
/// trees with stems of 0.5 m radius lift plates of about 2.5 m (Mattheck and Breloer 1994).
inline constexpr float kRootPlate = 5;

/// The edge of the root plate, or of the stump, on the side to which an uprooted tree falls, on the slope of
/// the ground there: the fall without its course.
Fall hinge_of(const Standing& now, const GrownTree& tree, const GroundHeight& ground);

/// All of the fall of a tree that is uprooted, which stands as `now` when it begins. Its start is 0.
Fall fall_of(const Standing& now, const GrownTree& tree, const Species& species, const GroundHeight& ground);

/// Turns a model at rest as it lies in the end on level ground, for copies, which have no fall of their own.
void lay_down(Model& model, const Fall& fall);

}  // namespace frond
