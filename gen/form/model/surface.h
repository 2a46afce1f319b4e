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
  /// grey 0..1, NaN where it has none, below 0 where nothing may creep (model/barred.h); may be empty.
  std::vector<std::array<Vec3, 3>> paint{};

  /// Checks all invariants: one line for the first violation, empty if there is none.
  std::string find_fault() const;
};

/// The paint of a corner without any.
inline constexpr Vec3 kUnpainted{std::numeric_limits<float>::quiet_NaN()};

/// Appends a mesh; both have `uv` or neither, unless the target is empty.
void append(Surface& to, const Surface& more);

/// Appends a mesh, scaled along its own axes (each > 0), rotated and moved; both have `uv` or neither, unless
/// the target is empty.
void append_placed(Surface& to, const Surface& more, Vec3 at, Quat turn, Vec3 scale);

/// The surface's area, m2.
double area(const Surface& surface);

/// Sets the normals from the triangles, weighted by area.
void set_normals(Surface& surface);

}  // namespace frond
