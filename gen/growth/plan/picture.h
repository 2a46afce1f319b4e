#pragma once

#include <span>
#include <string>

#include "plan/plan.h"

namespace frond {

/// Plans side by side as SVG, seen from above, the back at the top: ground, ways, walls and edges of rooms,
/// and the symbol of each room.
std::string plans_svg(const PlanText& text, std::span<const GroundPlan> plans);

}  // namespace frond
