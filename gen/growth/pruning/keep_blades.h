#pragma once

#include <cstdint>
#include <vector>

#include "model/model.h"

namespace frond {

/// The name of the prototype of wounds, see add_cut_face().
inline constexpr const char* kSawn = "sawn";

/// Leaves out the blades that do not `stay`, with their points.
void keep_blades(Blades& blades, const std::vector<std::uint8_t>& stay);

}  // namespace frond
