#pragma once

#include <string_view>
#include <vector>

#include "plan/plan.h"

// What stands and lies where, by a plan. Metres, the middle of the plan at the origin, its front at +z.

namespace frond {

/// A rectangle about `at`, turned about the vertical: `size.x` along its own x, `size.y` along its own z. A
/// line has no depth, a point no size.
struct PlanSite {
  Vec2 at{0}, size{0};
  double turn = 0;  ///< radians, from +z toward +x
};

/// The names of sites besides those of rooms.
inline constexpr std::string_view kPlanGate = "gate", kPlanCorners = "corners", kPlanDoors = "doors",
                                  kPlanWalls = "walls";

/// Ways as few straight pieces, unturned. They end where rooms begin.
std::vector<PlanSite> way_sites(const PlanText& text, const GroundPlan& plan);

/// A room without its inset, turned so that its z leads out where one came in.
PlanSite room_site(const PlanText& text, const PlanRoom& room);

/// The sites that things stand in by that name: rooms, the gate, the four corners, or the doors of rooms, as
/// wide as openings.
std::vector<PlanSite> sites_in(const PlanText& text, const GroundPlan& plan, std::string_view name);

/// The lines that things stand along by that name: the walls round the plan, or the edges of rooms; open
/// where ways come in, each turned so that its z leads out.
std::vector<PlanSite> sites_along(const PlanText& text, const GroundPlan& plan, std::string_view name);

}  // namespace frond
