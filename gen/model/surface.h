#pragma once

#include <array>
#include <cstdint>
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
  std::vector<Vec2> uv;  ///< where on the texture each vertex lies; may be empty

  /// Where it is not what it promises: one line for the first fault, empty when all is well.
  std::string check() const;
};

/// Adds a mesh to another; both have `uv` or neither, unless there is nothing yet.
void append(Surface& to, const Surface& more);

/// The same, scaled along its own axes (each > 0), turned and moved.
void append_placed(Surface& to, const Surface& more, Vec3 at, Quat turn, Vec3 scale);

/// The surface's area, m2.
double area(const Surface& surface);

/// Sets the normals from the triangles, each weighted by its area.
void set_normals(Surface& surface);

}  // namespace frond
