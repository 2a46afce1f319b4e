#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/vec.h"

namespace frond {

/// A triangle mesh with a normal at each vertex. Plain data; metres. Triangles run counter-clockwise seen
/// from outside.
struct Surface {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;
  std::vector<std::array<std::uint32_t, 3>> triangle;
  std::vector<Vec2> uv;  ///< texture coordinates of each vertex; may be empty
  /// For each corner of each triangle what masks find there: texture coordinates u and v (v upward) and a
  /// grey 0..1, NaN where it has none, below 0 where nothing may creep (kBarred); may be empty.
  std::vector<std::array<Vec3, 3>> paint{};

  /// Checks all invariants: one line for the first violation, empty if there is none.
  std::string find_fault() const;
};

/// The paint of a corner without any.
inline constexpr Vec3 kUnpainted{std::numeric_limits<float>::quiet_NaN()};
/// The grey where nothing may creep; anything below 0 says so.
inline constexpr float kBarred = -1;

/// The area vector of a triangle, twice as long as the triangle is large.
inline Vec3 area_of(const Surface& s, const std::array<std::uint32_t, 3>& triangle) {
  auto [a, b, c] = triangle;
  return glm::cross(s.position[b] - s.position[a], s.position[c] - s.position[a]);
}

/// Adds a face of four corners as two triangles, cut from a to c.
inline void add_quad(Surface& s, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  s.triangle.push_back({a, b, c});
  s.triangle.push_back({a, c, d});
}

/// Adds the faces between rows of vertices, from `start` on, counter-clockwise seen from where each row runs
/// to the right and the next one is above it.
void stitch_rows(Surface& surface, std::uint32_t start, std::uint32_t rows, std::uint32_t columns);

/// Appends a mesh with its places and normals mapped; both have `uv` or neither, unless the target is empty.
template <class Place, class Normal>
void append_mapped(Surface& to, const Surface& more, const Place& place, const Normal& normal);

/// Appends a mesh; both have `uv` or neither, unless the target is empty.
void append(Surface& to, const Surface& more);

/// Appends a mesh, scaled along its own axes (each > 0), rotated and moved; both have `uv` or neither, unless
/// the target is empty.
void append_placed(Surface& to, const Surface& more, Vec3 at, Quat turn, Vec3 scale);

/// The surface's area, m2.
double area(const Surface& surface);

/// Sets the normals from the triangles, weighted by area.
void set_normals(Surface& surface);

/// Appends all of a mesh but its places and normals; `first` is the number that its first vertex has now.
void append_faces(Surface& to, const Surface& more, std::size_t first);

template <class Place, class Normal>
void append_mapped(Surface& to, const Surface& more, const Place& place, const Normal& normal) {
  std::size_t first = to.position.size();
  for (const Vec3& p : more.position) to.position.push_back(place(p));
  for (const Vec3& n : more.normal) to.normal.push_back(normal(n));
  append_faces(to, more, first);
}

}  // namespace frond
