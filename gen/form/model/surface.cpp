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

void append_faces(Surface& to, const Surface& more, std::size_t first) {
  auto offset = static_cast<std::uint32_t>(first);
  to.uv.insert(to.uv.end(), more.uv.begin(), more.uv.end());
  append_paint(to, more);
  for (auto [a, b, c] : more.triangle) to.triangle.push_back({a + offset, b + offset, c + offset});
}

void append(Surface& to, const Surface& more) {
  assert(to.position.empty() || to.uv.empty() == more.uv.empty());
  std::size_t first = to.position.size();
  to.position.insert(to.position.end(), more.position.begin(), more.position.end());
  to.normal.insert(to.normal.end(), more.normal.begin(), more.normal.end());
  append_faces(to, more, first);
}

void append_placed(Surface& to, const Surface& more, Vec3 at, Quat turn, Vec3 scale) {
  assert(scale.x > 0 && scale.y > 0 && scale.z > 0);
  assert(std::abs(glm::length(turn) - 1) < 1e-3f);
  assert(more.normal.size() == more.position.size());
  append_mapped(
      to, more, [&](Vec3 p) { return at + turn * (p * scale); },
      [&](Vec3 n) { return glm::normalize(turn * (n / scale)); });
}

void stitch_rows(Surface& surface, std::uint32_t start, std::uint32_t rows, std::uint32_t columns) {
  for (std::uint32_t r = 0; r + 1 < rows; ++r)
    for (std::uint32_t c = 0; c + 1 < columns; ++c) {
      std::uint32_t i = start + r * columns + c;
      add_quad(surface, i, i + 1, i + columns + 1, i + columns);
    }
}

double area(const Surface& s) {
  double sum = 0;
  for (const auto& triangle : s.triangle) sum += 0.5 * glm::length(area_of(s, triangle));
  return sum;
}

void set_normals(Surface& surface) {
  surface.normal.assign(surface.position.size(), Vec3(0));
  for (const auto& triangle : surface.triangle) {
    Vec3 area = area_of(surface, triangle);
    for (std::uint32_t corner : triangle) surface.normal[corner] += area;
  }
  for (Vec3& n : surface.normal) {
    float length = glm::length(n);
    n = length > 0 ? n / length : Vec3(0, 1, 0);
  }
}

}  // namespace frond
