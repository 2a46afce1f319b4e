#include "core/bezier.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace frond {

BezierJet bezier_jet(std::span<const glm::dvec2> control, double t) {
  assert(!control.empty());
  // Curves of the usual degrees need no memory of their own.
  std::array<glm::dvec2, 24> few;
  std::vector<glm::dvec2> many;
  if (control.size() > few.size()) many.resize(control.size());
  std::span level = many.empty() ? std::span<glm::dvec2>(few).first(control.size()) : std::span(many);
  std::copy(control.begin(), control.end(), level.begin());
  std::size_t degree = control.size() - 1;
  auto n = static_cast<double>(degree);
  BezierJet jet;
  for (std::size_t left = degree; left > 0; --left) {
    // The last three and the last two points before the end give the derivatives.
    if (left == 2) jet.bend = (level[2] - level[1] * 2.0 + level[0]) * (n * (n - 1));
    if (left == 1) jet.slope = (level[1] - level[0]) * n;
    for (std::size_t i = 0; i < left; ++i) level[i] = level[i] * (1 - t) + level[i + 1] * t;
  }
  jet.at = level[0];
  return jet;
}

std::vector<glm::dvec2> bezier_raised(std::span<const glm::dvec2> control) {
  assert(!control.empty());
  std::vector<glm::dvec2> raised{control.front()};
  auto count = static_cast<double>(control.size());
  for (std::size_t i = 1; i < control.size(); ++i) {
    double share = static_cast<double>(i) / count;
    raised.push_back(control[i - 1] * share + control[i] * (1 - share));
  }
  raised.push_back(control.back());
  return raised;
}

}  // namespace frond
