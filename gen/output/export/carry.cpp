#include "export/carry.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "geometry/far.h"

namespace frond {

namespace {

constexpr float kStill = 1e-5f;  // metres: less is no movement

}  // namespace

ExportShift carried_on(const Skeleton& rest, const Pose& from, const Pose& to, const Surface& surface,
                       std::span<const std::int32_t> node) {
  assert(node.size() == surface.position.size());
  ExportShift shift;
  for (std::size_t v = 0; v < node.size(); ++v) {
    std::int32_t n = node[v], below = rest.parent[n] == Skeleton::kRoot ? n : rest.parent[n];
    Vec3 foot = from.position[below], offset = from.position[n] - foot, at = surface.position[v];
    float length2 = glm::dot(offset, offset);
    float along = length2 > 1e-14f ? std::clamp(glm::dot(at - foot, offset) / length2, 0.0f, 1.0f) : 1;
    // Where a branch leaves a fork it is as thick as it goes on.
    float thin = below == n - 1 ? along : 1;
    float before = glm::mix(from.radius[below], from.radius[n], thin),
          after = glm::mix(to.radius[below], to.radius[n], thin);
    Quat turn = to.turn[n] * glm::conjugate(from.turn[n]);
    Vec3 aside = turn * (at - (foot + along * offset)) * (before > 0 ? after / before : 0);
    shift.position.push_back(glm::mix(to.position[below], to.position[n], along) + aside - at);
    shift.normal.push_back(turn * surface.normal[v] - surface.normal[v]);
  }
  return shift;
}

ExportShift shift_between(const Surface& from, const Surface& to) {
  assert(from.position.size() == to.position.size());
  ExportShift shift;
  for (std::size_t v = 0; v < from.position.size(); ++v) {
    shift.position.push_back(to.position[v] - from.position[v]);
    shift.normal.push_back(to.normal[v] - from.normal[v]);
  }
  return shift;
}

Surface Simplified::of(const Surface& other) const {
  Surface moved = surface;
  for (std::size_t v = 0; v < source.size(); ++v)
    moved.position[v] = other.position[source[v]], moved.normal[v] = other.normal[source[v]];
  return moved;
}

Simplified drawn_with(const Surface& whole, double triangles) {
  Simplified simple;
  if (triangles < static_cast<double>(whole.triangle.size()))
    simple.surface = reduced(whole, static_cast<std::size_t>(triangles), &simple.source);
  else
    simple.surface = whole;
  if (simple.source.empty()) {
    simple.source.resize(simple.surface.position.size());
    std::iota(simple.source.begin(), simple.source.end(), 0u);
  }
  return simple;
}

void append_shift(ExportPart& part, std::size_t key, std::size_t first, const Surface& there,
                  const ExportPlacement& placement) {
  Surface placed;
  append_placed(placed, there, placement.at, placement.turn, placement.scale);
  if (part.shifts.size() <= key) part.shifts.resize(key + 1);
  ExportShift& shift = part.shifts[key];
  for (std::size_t v = 0; v < placed.position.size(); ++v) {
    shift.position.push_back(placed.position[v] - part.surface.position[first + v]);
    shift.normal.push_back(placed.normal[v] - part.surface.normal[first + v]);
  }
}

void leave_out_still(std::vector<ExportPart>& parts) {
  auto still = [](const ExportShift& shift) {
    return std::ranges::all_of(shift.position, [](Vec3 by) { return glm::dot(by, by) < kStill * kStill; });
  };
  if (std::ranges::all_of(parts,
                          [&](const ExportPart& part) { return std::ranges::all_of(part.shifts, still); }))
    for (ExportPart& part : parts) part.shifts.clear();
}

}  // namespace frond
