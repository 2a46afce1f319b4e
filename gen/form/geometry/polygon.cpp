#include "geometry/polygon.h"

#include <algorithm>
#include <cassert>
#include <glm/vec2.hpp>
#include <limits>
#include <numeric>

namespace frond {

namespace {

using Flat = std::vector<glm::dvec2>;
using CutList = std::vector<std::array<std::uint32_t, 3>>;

constexpr std::size_t kMostAtOnce = 160;  // corners among which the best cuts are looked for
constexpr std::size_t kMostEntangled = 2000;
constexpr double kThin = 1e-12;  // area of a triangle without any, of a polygon about one unit large

double flat_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// The polygon as seen from the side of its area, about one unit large.
Flat flatten(std::span<const DVec3> points) {
  auto [x, y] = plane_axes(points);
  double extent = 0;
  for (const DVec3& p : points) extent = std::max(extent, glm::distance(p, points[0]));
  if (!(extent > 0)) extent = 1;
  Flat flat;
  for (const DVec3& p : points)
    flat.emplace_back(glm::dot(p - points[0], x) / extent, glm::dot(p - points[0], y) / extent);
  return flat;
}

/// Finds the triangulation of least weight by that of all its parts (Gilbert 1979, Klincsek 1980). Triangles
/// that look the other way weigh most, then those without area, then the length of cuts. Where none looks the
/// other way the triangles cover the polygon once, whatever its outline does.
class BestCuts {
 public:
  BestCuts(const Flat& flat, const std::vector<std::uint32_t>& corners)
      : flat_(flat), corners_(corners), weight_(count() * count(), 0), apex_(count() * count(), 0) {
    for (std::size_t span = 2; span < count(); ++span)
      for (std::size_t from = 0; from + span < count(); ++from) settle(from, from + span);
  }

  void append_to(CutList& triangles) const {
    std::vector<std::array<std::size_t, 3>> parts{{0, count() - 1, 0}};  // the last: cut already
    while (!parts.empty()) {
      auto [from, to, cut] = parts.back();
      parts.pop_back();
      if (to < from + 2) continue;
      std::size_t apex = apex_[from * count() + to];
      if (cut) {
        triangles.push_back({corners_[from], corners_[apex], corners_[to]});
        continue;
      }
      parts.push_back({apex, to, 0});
      parts.push_back({from, to, 1});
      parts.push_back({from, apex, 0});
    }
  }

 private:
  std::size_t count() const { return corners_.size(); }
  const glm::dvec2& at(std::size_t i) const { return flat_[corners_[i]]; }

  /// The best triangle over the edge between two corners, with what lies on both its sides.
  void settle(std::size_t from, std::size_t to) {
    constexpr double kTurned = 1e9, kEmpty = 1e3, kEqual = 1e-9;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t apex = from + 1; apex < to; ++apex) {
      double sides = weight_[from * count() + apex] + weight_[apex * count() + to];
      if (sides >= best) continue;
      double area = flat_area(at(from), at(apex), at(to));
      double weight = sides + (area < -kThin ? kTurned * -area : 0) + (area < kThin ? kEmpty : 0);
      if (weight < best - kEqual)
        best = weight, apex_[from * count() + to] = static_cast<std::uint32_t>(apex);
    }
    bool outline = from == 0 && to + 1 == count();
    weight_[from * count() + to] = best + (outline ? 0 : glm::distance(at(from), at(to)));
  }

  const Flat& flat_;
  const std::vector<std::uint32_t>& corners_;
  std::vector<double> weight_;
  std::vector<std::uint32_t> apex_;
};

/// Cuts ears off until few corners are left: those in whose triangle, edges included, no other corner lies.
void cut_ears(const Flat& flat, std::vector<std::uint32_t>& left, CutList& triangles) {
  auto is_ear = [&](std::size_t i) {
    std::size_t n = left.size(), before = (i + n - 1) % n, after = (i + 1) % n;
    glm::dvec2 a = flat[left[before]], b = flat[left[i]], c = flat[left[after]];
    if (flat_area(a, b, c) < 1e3 * kThin / static_cast<double>(flat.size())) return false;
    for (std::size_t k = 0; k < n; ++k) {
      if (k == before || k == i || k == after) continue;
      const glm::dvec2& p = flat[left[k]];
      if (flat_area(a, b, p) >= -kThin && flat_area(b, c, p) >= -kThin && flat_area(c, a, p) >= -kThin)
        return false;
    }
    return true;
  };
  std::size_t at = 0, tried = 0;
  while (left.size() > kMostAtOnce && tried <= left.size()) {
    std::size_t n = left.size();
    at %= n;
    if (!is_ear(at)) {
      ++at, ++tried;
      continue;
    }
    triangles.push_back({left[(at + n - 1) % n], left[at], left[(at + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    ++at, tried = 0;  // not the next one at once, so that ears do not all meet in one corner
  }
}

}  // namespace

bool triangulate_polygon(std::span<const DVec3> points, CutList& triangles) {
  assert(points.size() >= 3);
  if (points.size() == 3) return triangles.push_back({0, 1, 2}), true;
  Flat flat = flatten(points);
  std::vector<std::uint32_t> left(points.size());
  std::iota(left.begin(), left.end(), 0u);
  cut_ears(flat, left, triangles);
  if (left.size() > kMostEntangled) return false;
  BestCuts(flat, left).append_to(triangles);
  return true;
}

}  // namespace frond
