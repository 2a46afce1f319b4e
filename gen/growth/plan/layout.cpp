#include "plan/layout.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

constexpr float kShortest = 0.1f;  // metres, of a line

/// The middle of a cell.
Vec2 middle_of(const PlanText& text, Vec2 cell) {
  Vec2 half = Vec2(text.size[0] - 1, text.size[1] - 1) / 2.0f;
  return static_cast<float>(text.cell) * Vec2(cell.x - half.x, half.y - cell.y);
}

/// The rectangle between two cells, `inset` metres within their outer edges.
PlanSite rectangle(const PlanText& text, PlanCell low, PlanCell high, double inset) {
  Vec2 size = static_cast<float>(text.cell) * Vec2(high - low + 1) - 2 * static_cast<float>(inset);
  return {middle_of(text, Vec2(low + high) / 2.0f), size};
}

/// An opening of a room: the step that leads out of it or in.
struct Door {
  Vec2 at{0};   // on the edge of the room
  Vec2 out{0};  // of length 1, away from it
  bool operator==(const Door&) const = default;
};

/// Where a step crosses the edge of that room.
Door door_of(const PlanText& text, const PlanRoom& room, const PlanStep& step) {
  bool leaves = room.holds(step.from);
  PlanCell inner = leaves ? step.from : step.to, outer = leaves ? step.to : step.from;
  Vec2 out(outer.x - inner.x, inner.y - outer.y);
  auto edge = static_cast<float>(text.cell / 2 - text.rooms[room.kind].inset);
  return {middle_of(text, Vec2(inner)) + edge * out, out};
}

std::vector<Door> doors_of(const PlanText& text, const GroundPlan& plan, const PlanRoom& room) {
  std::vector<Door> doors;
  for (const PlanStep& step : plan.steps)
    if (room.holds(step.from) != room.holds(step.to)) {
      Door door = door_of(text, room, step);
      if (std::ranges::find(doors, door) == doors.end()) doors.push_back(door);
    }
  return doors;
}

/// The edges of an unturned rectangle as lines, open by `opening` metres about each door.
void append_edges(std::vector<PlanSite>& lines, const PlanSite& of, const std::vector<Door>& doors,
                  double opening) {
  for (int side = 0; side < 4; ++side) {
    double turn = side * kPi / 2;
    Vec2 out(std::round(std::sin(turn)), std::round(std::cos(turn))), along(out.y, -out.x);
    Vec2 middle = of.at + 0.5f * of.size * out;
    float half = std::abs(glm::dot(of.size, along)) / 2;
    std::vector<float> gaps;  // their middles along the edge
    for (const Door& door : doors)
      if (glm::dot(door.out, out) > 0.5f) gaps.push_back(glm::dot(door.at - middle, along));
    std::ranges::sort(gaps);
    float from = -half;
    auto line = [&](float to) {
      if (to - from >= kShortest)
        lines.push_back({middle + along * ((from + to) / 2), Vec2(to - from, 0), turn});
    };
    for (float gap : gaps) {
      line(gap - static_cast<float>(opening) / 2);
      from = gap + static_cast<float>(opening) / 2;
    }
    line(half);
  }
}

/// Where a way ends that comes from a cell toward its neighbour: past the middle of a cell of ways, so that
/// corners are filled; at the edge of a room.
Vec2 way_end(const PlanText& text, const GroundPlan& plan, PlanCell end, Vec2 toward) {
  Vec2 middle = middle_of(text, Vec2(end));
  int here = plan.at(end);
  if (here < 0) return middle + toward * static_cast<float>(text.way / 2);
  double inset = text.rooms[plan.rooms[static_cast<std::size_t>(here)].kind].inset;
  return middle - toward * static_cast<float>(text.cell / 2 - inset);
}

}  // namespace

std::vector<PlanSite> way_sites(const PlanText& text, const GroundPlan& plan) {
  std::vector<PlanSite> ways;
  for (int axis = 0; axis < 2; ++axis) {
    PlanCell next(axis == 0, axis == 1);
    // Steps along the axis as their lower cells, in lines.
    std::vector<PlanCell> lower;
    for (const PlanStep& step : plan.steps)
      if ((step.from.x != step.to.x) == (axis == 0)) lower.push_back(glm::min(step.from, step.to));
    auto key = [&](PlanCell c) { return std::pair(c[1 - axis], c[axis]); };
    std::ranges::sort(lower, {}, key);
    auto repeated = std::ranges::unique(lower);
    lower.erase(repeated.begin(), repeated.end());
    for (std::size_t i = 0; i < lower.size();) {
      PlanCell low = lower[i], high = low + next;
      for (++i; i < lower.size() && lower[i] == high && plan.at(high) == GroundPlan::kWay; ++i) high += next;
      Vec2 forth(next.x, -next.y);
      Vec2 a = way_end(text, plan, low, -forth), b = way_end(text, plan, high, forth);
      Vec2 across = static_cast<float>(text.way) * Vec2(axis == 1, axis == 0);
      ways.push_back({(a + b) / 2.0f, glm::abs(b - a) + across});
    }
  }
  return ways;
}

PlanSite room_site(const PlanText& text, const PlanRoom& room) {
  PlanSite site = rectangle(text, room.low, room.high, text.rooms[room.kind].inset);
  if (room.facing % 2) std::swap(site.size.x, site.size.y);
  site.turn = room.facing * kPi / 2;
  return site;
}

std::vector<PlanSite> sites_in(const PlanText& text, const GroundPlan& plan, std::string_view name) {
  std::vector<PlanSite> sites;
  PlanSite all = rectangle(text, PlanCell(0), PlanCell(text.size[0], text.size[1]) - 1, 0);
  auto opening = static_cast<float>(text.opening);
  if (name == kPlanGate)
    sites.push_back({Vec2(middle_of(text, Vec2(plan.steps[0].to)).x, all.size.y / 2), Vec2(opening, 0), 0});
  if (name == kPlanCorners)
    for (int i = 0; i < 4; ++i)
      sites.push_back({0.5f * all.size * Vec2(i % 3 ? 1 : -1, i < 2 ? 1 : -1), Vec2(0), 0});
  for (const PlanRoom& room : plan.rooms) {
    if (name == text.rooms[room.kind].name) sites.push_back(room_site(text, room));
    if (name != kPlanDoors) continue;
    for (const Door& door : doors_of(text, plan, room))
      sites.push_back({door.at, Vec2(opening, 0), std::atan2(door.out.x, door.out.y)});
  }
  return sites;
}

std::vector<PlanSite> sites_along(const PlanText& text, const GroundPlan& plan, std::string_view name) {
  std::vector<PlanSite> lines;
  if (name == kPlanWalls) {
    PlanSite gate = sites_in(text, plan, kPlanGate)[0];
    append_edges(lines, rectangle(text, PlanCell(0), PlanCell(text.size[0], text.size[1]) - 1, 0),
                 {{gate.at, Vec2(0, 1)}}, text.opening);
  }
  for (const PlanRoom& room : plan.rooms)
    if (name == text.rooms[room.kind].name)
      append_edges(lines, rectangle(text, room.low, room.high, text.rooms[room.kind].inset),
                   doors_of(text, plan, room), text.opening);
  return lines;
}

}  // namespace frond
