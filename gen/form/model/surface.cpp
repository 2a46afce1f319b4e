#include "model/surface.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace frond {

std::string Surface::find_fault() const {
  if (normal.size() != position.size()) return "the arrays differ in length";
  if (!uv.empty() && uv.size() != position.size()) return "not every vertex has a place on the texture";
  if (!paint.empty() && paint.size() != triangle.size()) return "not every triangle has its paint";
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (!std::isfinite(glm::dot(position[i], position[i])))
      return fmt::format("vertex {} is not at a finite place", i);
    if (!(std::abs(glm::length(normal[i]) - 1) <= 1e-3f))
      return fmt::format("normal {} is not of length 1", i);
  }
  for (std::size_t i = 0; i < triangle.size(); ++i) {
    auto [a, b, c] = triangle[i];
    if (a >= position.size() || b >= position.size() || c >= position.size())
      return fmt::format("triangle {} names a vertex that is not there", i);
    if (a == b || b == c || c == a) return fmt::format("triangle {} names a vertex twice", i);
  }
  return {};
}

namespace {

/// Adds the paint of more triangles, before these are added.
void append_paint(Surface& to, const Surface& more) {
  if (to.paint.empty() && more.paint.empty()) return;
  constexpr std::array<Vec3, 3> none{kUnpainted, kUnpainted, kUnpainted};
  to.paint.resize(to.triangle.size(), none);
  to.paint.insert(to.paint.end(), more.paint.begin(), more.paint.end());
  to.paint.resize(to.triangle.size() + more.triangle.size(), none);
}

}  // namespace

void append(Surface& to, const Surface& more) {
  assert(to.position.empty() || to.uv.empty() == more.uv.empty());
  auto offset = static_cast<std::uint32_t>(to.position.size());
  to.position.insert(to.position.end(), more.position.begin(), more.position.end());
  to.normal.insert(to.normal.end(), more.normal.begin(), more.normal.end());
  to.uv.insert(to.uv.end(), more.uv.begin(), more.uv.end());
  append_paint(to, more);
  for (auto [a, b, c] : more.triangle) to.triangle.push_back({a + offset, b + offset, c + offset});
}

void append_placed(Surface& to, const Surface& more, Vec3 at, Quat turn, Vec3 scale) {
  assert(scale.x > 0 && scale.y > 0 && scale.z > 0);
  assert(std::abs(glm::length(turn) - 1) < 1e-3f);
  assert(more.normal.size() == more.position.size());
  auto offset = static_cast<std::uint32_t>(to.position.size());
  for (const Vec3& p : more.position) to.position.push_back(at + turn * (p * scale));
  for (const Vec3& n : more.normal) to.normal.push_back(glm::normalize(turn * (n / scale)));
  to.uv.insert(to.uv.end(), more.uv.begin(), more.uv.end());
  append_paint(to, more);
  for (auto [a, b, c] : more.triangle) to.triangle.push_back({a + offset, b + offset, c + offset});
}

double area(const Surface& s) {
  double sum = 0;
  for (auto [a, b, c] : s.triangle)
    sum += 0.5 * glm::length(glm::cross(s.position[b] - s.position[a], s.position[c] - s.position[a]));
  return sum;
}

void set_normals(Surface& surface) {
  surface.normal.assign(surface.position.size(), Vec3(0));
  for (auto [a, b, c] : surface.triangle) {
    const Vec3& p = surface.position[a];
    Vec3 area = glm::cross(surface.position[b] - p, surface.position[c] - p);
    surface.normal[a] += area;
    surface.normal[b] += area;
    surface.normal[c] += area;
  }
  for (Vec3& n : surface.normal) {
    float length = glm::length(n);
    n = length > 0 ? n / length : Vec3(0, 1, 0);
  }
}

}  // namespace frond
