#pragma once

#include <span>
#include <vector>

#include "core/vec.h"

namespace frond {

/// The turns of the segments of a limb that is pulled by a force at one place, as a beam that is clamped at
/// its foot: by M l / (E I), with the moment M of the force at each joint and I ~ r^4 of round wood (Gere and
/// Timoshenko 1997, Mechanics of Materials), so that the place moves by about `by`, or as near as the length
/// allows. Large bends are made of many small loads, each on the shape that the ones before have left. Wood
/// thinner than a third of the thickest is taken for as stiff as that: a wire holds it. `nodes`: the clamp
/// first; `radius`: of each segment, one less; the place is `within` the last segment.
std::vector<Quat> bend_turns(std::span<const Vec3> nodes, std::span<const float> radius, float within,
                             Vec3 by);

}  // namespace frond
