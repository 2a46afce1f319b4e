#include "masonry/arch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/bezier.h"

namespace frond {

namespace {

constexpr std::size_t kSteps = 1024;

BezierJet half_at(const Arch& arch, double t) {
  std::array<glm::dvec2, 3> control{
      {{arch.length / 2, 0}, {arch.crown * arch.length, arch.height}, {0, arch.height}}};
  return bezier_jet(control, t);
}

/// The unit vector along one half, from its foot to mid-span.
glm::dvec2 heading_at(const Arch& arch, double t) {
  glm::dvec2 slope = half_at(arch, t).slope;
  double speed = glm::length(slope);
  // A flat arch whose control point lies on its foot stands still there.
  return speed > 1e-12 ? slope / speed : glm::dvec2(-1, 0);
}

}  // namespace

Arch make_arch(double length, double height, double crown) {
  Arch arch{length, height, crown, {0}};
  glm::dvec2 last = half_at(arch, 0).at;
  for (std::size_t i = 1; i <= kSteps; ++i) {
    glm::dvec2 next = half_at(arch, static_cast<double>(i) / kSteps).at;
    arch.distance.push_back(arch.distance.back() + glm::distance(last, next));
    last = next;
  }
  return arch;
}

double half_length(const Arch& arch) { return arch.distance.back(); }

ArchPoint arch_at(const Arch& arch, double s) {
  double from_foot = half_length(arch) - std::abs(s), t = 0;
  if (from_foot > 0) {
    auto above = std::lower_bound(arch.distance.begin() + 1, arch.distance.end() - 1, from_foot);
    double low = *(above - 1), share = (from_foot - low) / std::max(*above - low, 1e-300);
    t = (static_cast<double>(above - 1 - arch.distance.begin()) + std::min(share, 1.0)) / kSteps;
  }
  ArchPoint p{half_at(arch, t).at, -heading_at(arch, t), {}};
  if (from_foot < 0) p.at -= p.along * from_foot;
  if (s < 0) {
    p.at.x = -p.at.x;
    p.along.y = -p.along.y;
  }
  p.up = {-p.along.y, p.along.x};
  return p;
}

double arch_height(const Arch& arch, double x) {
  // x(t) = a - 2 (a - p) t + (a - 2 p) t^2, which only falls; its root in the form that does not cancel.
  double a = arch.length / 2, p = arch.crown * arch.length, rest = a - std::min(std::abs(x), a);
  if (rest <= 0) return 0;
  double b = 2 * (a - p), root = std::sqrt(std::max(0.0, b * b - 4 * (a - 2 * p) * rest));
  return half_at(arch, std::min(1.0, 2 * rest / (b + root))).at.y;
}

double least_radius(const Arch& arch) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i <= kSteps; ++i) {
    auto jet = half_at(arch, static_cast<double>(i) / kSteps);
    double turn = std::abs(jet.slope.x * jet.bend.y - jet.slope.y * jet.bend.x);
    if (turn > 1e-12) least = std::min(least, std::pow(glm::length(jet.slope), 3) / turn);
  }
  return least;
}

}  // namespace frond
