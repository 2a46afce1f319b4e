#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "core/vec.h"

namespace frond {

/// Whether the segment between two points crosses a triangle (Moeller and Trumbore 1997).
inline bool goes_through(Vec3 from, Vec3 to, const std::array<Vec3, 3>& triangle) {
  DVec3 start(from), corner(triangle[0]), segment = DVec3(to) - start, e1 = DVec3(triangle[1]) - corner,
                                          e2 = DVec3(triangle[2]) - corner, h = glm::cross(segment, e2);
  double volume = glm::dot(e1, h);
  if (std::abs(volume) < 1e-18) return false;
  DVec3 off = start - corner, k = glm::cross(off, e1);
  double u = glm::dot(off, h) / volume, v = glm::dot(segment, k) / volume, share = glm::dot(e2, k) / volume;
  return u >= 0 && v >= 0 && u + v <= 1 && share >= 0 && share <= 1;
}

/// The bounding box of a triangle, low and high.
template <class Place>
std::array<Vec3, 2> box_of(const std::array<std::uint32_t, 3>& t, const Place& place) {
  Vec3 a = place(t[0]), b = place(t[1]), c = place(t[2]);
  return {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
}

inline bool boxes_meet(const std::array<Vec3, 2>& a, const std::array<Vec3, 2>& b) {
  return a[0].x <= b[1].x && b[0].x <= a[1].x && a[0].y <= b[1].y && b[0].y <= a[1].y && a[0].z <= b[1].z &&
         b[0].z <= a[1].z;
}

/// Whether two triangles intersect anywhere but at shared corners. `place(v)` is the position of a vertex.
template <class Place>
bool triangles_cross(const std::array<std::uint32_t, 3>& one, const std::array<std::uint32_t, 3>& other,
                     const Place& place) {
  std::array<Vec3, 3> p{place(one[0]), place(one[1]), place(one[2])},
      q{place(other[0]), place(other[1]), place(other[2])};
  auto shared = [](std::uint32_t v, const std::array<std::uint32_t, 3>& t) {
    return v == t[0] || v == t[1] || v == t[2];
  };
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t next = k == 2 ? 0 : k + 1;
    if (!shared(one[k], other) && !shared(one[next], other) && goes_through(p[k], p[next], q)) return true;
    if (!shared(other[k], one) && !shared(other[next], one) && goes_through(q[k], q[next], p)) return true;
  }
  return false;
}

}  // namespace frond
