#include "crown/along_parent.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace frond {

namespace {

constexpr std::size_t kSteps = 256;

/// How much lies below each of the places that cut a stretch into steps of one length.
std::array<double, kSteps + 1> sums(const Curve& density, double from, double to) {
  std::array<double, kSteps + 1> sum{};
  for (std::size_t i = 0; i < kSteps; ++i)
    sum[i + 1] = sum[i] + factor_along(density, from + (to - from) * (static_cast<double>(i) + 0.5) / kSteps);
  return sum;
}

constexpr double kLeastFactor = 0.05,
                 kMostFactor = 10;  // factors: what is shorter still would have no direction

float factor_at(const Curve& curve, float place) {
  return static_cast<float>(
      std::clamp(factor_along(curve, static_cast<double>(place)), kLeastFactor, kMostFactor));
}

/// For each node that begins an axis, the last node of that axis; 0 for the others.
std::vector<std::size_t> axis_ends(std::span<const std::int32_t> parent, std::span<const AxisNode> axes) {
  std::vector<std::size_t> start(parent.size()), end(parent.size());
  for (std::size_t i = 0; i < parent.size(); ++i) {
    bool goes_on = parent[i] != Skeleton::kRoot && axes[i].number == 0;
    start[i] = goes_on ? start[parent[i]] : i;
    end[start[i]] = i;
  }
  return end;
}

/// The turn that brings a branch to so many times its angle from a direction.
Quat turned_from(Vec3 along, Vec3 chord, double factor) {
  const Vec3 axis = glm::cross(along, chord);
  const float sine = glm::length(axis), cosine = glm::dot(along, chord);
  if (sine < 1e-6f * glm::length(along) * glm::length(chord)) return Quat(1, 0, 0, 0);
  const double angle = std::atan2(static_cast<double>(sine), static_cast<double>(cosine));
  const double wanted = std::min(angle * factor, kPi);
  return glm::angleAxis(static_cast<float>(wanted - angle), axis / sine);
}

}  // namespace

bool is_even(const Curve& curve) {
  return std::ranges::all_of(curve.points(), [](Vec2 point) { return point.y == 1; });
}

double factor_along(const Curve& curve, double place) {
  return is_even(curve) ? 1 : std::max(curve(place), 0.0);
}

double mean_along(const Curve& curve, double from, double to) {
  return is_even(curve) ? 1 : sums(curve, from, to).back() / kSteps;
}

double place_by_density(const Curve& density, double from, double to, double share) {
  if (is_even(density)) return from + (to - from) * share;
  const std::array<double, kSteps + 1> sum = sums(density, from, to);
  const double due = share * sum.back();
  const auto above = std::upper_bound(sum.begin(), sum.end() - 1, due);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - sum.begin() - 1, 0));
  const double step = sum[i + 1] - sum[i];
  const double within = step > 0 ? std::min((due - sum[i]) / step, 1.0) : 0;
  return from + (to - from) * (static_cast<double>(i) + within) / kSteps;
}

ShapedAlong shape_along(std::span<const std::int32_t> parent, std::span<const AxisNode> axes,
                        std::span<const Vec3> position, std::span<const float> radius,
                        const BranchesAlong& by) {
  const std::size_t n = parent.size();
  assert(axes.size() == n && position.size() == n && radius.size() == n);
  const std::vector<std::size_t> ends = axis_ends(parent, axes);
  ShapedAlong to{{position.begin(), position.end()},
                 std::vector<Quat>(n, Quat(1, 0, 0, 0)),
                 std::vector<float>(n, 1),
                 std::vector<float>(n, 1)};
  std::vector<int> depth(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    if (parent[i] == Skeleton::kRoot) continue;
    const auto p = static_cast<std::size_t>(parent[i]);
    depth[i] = depth[p], to.turn[i] = to.turn[p], to.length[i] = to.length[p], to.radius[i] = to.radius[p];
    // A stem begins at its foot, whose number is its own.
    const bool leaves = axes[i].number > 0 && axes[p].number >= 0;
    if (leaves) ++depth[i];
    if (leaves && depth[i] <= 2) {
      const AlongParent& law = depth[i] == 1 ? by.branches : by.twigs;
      const float place = axes[p].share;
      const Vec3 along = parent[p] == Skeleton::kRoot ? Vec3(0, 1, 0) : position[p] - position[parent[p]];
      if (!is_even(law.angle))
        to.turn[i] = glm::normalize(
            to.turn[p] * turned_from(along, position[ends[i]] - position[p], factor_along(law.angle, place)));
      to.length[i] *= factor_at(law.length, place);
      if (!is_even(law.radius))
        to.radius[i] *= std::min(factor_at(law.radius, place), std::max(1.0f, radius[p] / radius[i]));
    }
    to.position[i] = to.position[p] + to.turn[i] * ((position[i] - position[p]) * to.length[i]);
  }
  return to;
}

}  // namespace frond
