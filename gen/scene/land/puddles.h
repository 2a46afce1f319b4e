#pragma once

#include <vector>

#include "land/flood.h"
#include "model/surface.h"

// Water that stands in the hollows of the ground.

namespace frond {

/// The water that stands on a piece of ground when it is so deep, metres, in each hollow that is deep enough,
/// and up to the brim in others: level faces, which the ground cuts to their shape. Larger depths have faces
/// of which those of smaller ones are a part. `full` are the levels of the ground's flood.
Surface puddles(const GroundGrid& ground, const std::vector<float>& full, double depth);

/// Depth of puddles when so many millimetres have fallen, metres: what runs together from land four times as
/// wide as they are, up to 4 cm, when it seeps away.
double puddle_depth(double fallen);

}  // namespace frond
