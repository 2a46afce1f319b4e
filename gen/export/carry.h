#pragma once

#include <span>

#include "export/cast.h"
#include "motion/motion.h"

namespace frond {

/// Where the surface of branches is in another pose: each vertex keeps its place on the branch, whose node it
/// has, and is as much nearer to its middle line as the branch is thinner there. What growth has not reached
/// yet lies in the growing tip.
CastShift carried_on(const Skeleton& rest, const Pose& from, const Pose& to, const Surface& surface,
                     std::span<const std::int32_t> node);

/// What leads from a surface to another one of the same triangles.
CastShift shift_between(const Surface& from, const Surface& to);

/// Takes the shifts from parts none of which moves by more than a hair.
void leave_out_still(std::vector<CastPart>& parts);

}  // namespace frond
