#include "geometry/outline.h"

#include <algorithm>

#include "geometry/polygon.h"

namespace frond {

namespace {

float cross2(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

float turn_at(Vec2 a, Vec2 b, Vec2 c) { return cross2(b - a, c - b); }

bool inside(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
  return cross2(b - a, p - a) >= 0 && cross2(c - b, p - b) >= 0 && cross2(a - c, p - c) >= 0;
}

/// The outline as seen from the side of its area.
std::vector<Vec2> flatten(std::span<const Vec3> points) {
  auto [x, y] = plane_axes(points);
  std::vector<Vec2> flat;
  flat.reserve(points.size());
  for (Vec3 p : points) flat.emplace_back(glm::dot(p - points[0], x), glm::dot(p - points[0], y));
  return flat;
}

bool is_ear(const std::vector<Vec2>& flat, const std::vector<std::uint32_t>& left, std::size_t i) {
  std::size_t n = left.size();
  Vec2 a = flat[left[(i + n - 1) % n]], b = flat[left[i]], c = flat[left[(i + 1) % n]];
  if (turn_at(a, b, c) <= 0) return false;
  for (std::uint32_t k : left) {
    Vec2 p = flat[k];
    if (p != a && p != b && p != c && inside(p, a, b, c)) return false;
  }
  return true;
}

}  // namespace

void triangulate(std::span<const Vec3> points, std::uint32_t offset,
                 std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (points.size() < 3) return;
  std::vector<Vec2> flat = flatten(points);
  std::vector<std::uint32_t> left;  // the points that no ear has taken yet
  for (std::uint32_t i = 0; i < points.size(); ++i) left.push_back(i);
  std::size_t at = 0, tried = 0;
  while (left.size() > 3) {
    std::size_t n = left.size();
    at %= n;
    // Where the outline crosses itself there may be no ear left; then any corner will do.
    if (!is_ear(flat, left, at) && tried++ < n) {
      ++at;
      continue;
    }
    triangles.push_back({offset + left[(at + n - 1) % n], offset + left[at], offset + left[(at + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    tried = 0;
  }
  triangles.push_back({offset + left[0], offset + left[1], offset + left[2]});
}

void add_outline(Surface& surface, std::span<const Vec3> points, Vec3 foot) {
  Vec3 area = polygon_area(points);
  float size = glm::length(area);
  if (!(size > 1e-12f)) return;
  Vec3 normal = area / size, tip = foot;
  for (const Vec3& p : points)
    if (glm::distance(p, foot) > glm::distance(tip, foot)) tip = p;
  Vec3 along = tip - foot;
  float length2 = std::max(glm::dot(along, along), 1e-12f);
  Vec3 across = glm::cross(normal, along);
  triangulate(points, static_cast<std::uint32_t>(surface.position.size()), surface.triangle);
  for (const Vec3& p : points) {
    surface.position.push_back(p);
    surface.normal.push_back(normal);
    surface.uv.emplace_back(glm::dot(p - foot, along) / length2, 0.5f - glm::dot(p - foot, across) / length2);
  }
}

}  // namespace frond
