#pragma once

#include <array>

#include "core/vec.h"
#include "model/surface.h"

namespace frond {

/// A rectangular piece of timber or stone about the origin, with rounded edges.
struct Block {
  Vec3 size{1};         ///< metres along x, y and z, each > 0
  float bevel = 0.01f;  ///< metres, radius of the edges; clamped to 0.45 of the smallest size
  std::array<int, 3> parts{
      1, 1, 1};  ///< in how many parts its faces are cut along each axis, so that it can be bent
};

/// The block as a closed mesh without `uv`.
Surface block_surface(const Block& block);

/// Moves each vertex to `place(vertex)` and recomputes the normals. `place` must keep the orientation.
template <class Place>
void bend(Surface& surface, const Place& place) {
  for (Vec3& p : surface.position) p = place(p);
  set_normals(surface);
}

/// Volume enclosed by the triangles, cubic metres; negative if they are inside out.
double volume(const Surface& surface);

/// A colour with its brightness multiplied, and made warmer by a share.
Color toned(const Color& color, double brightness, double warmth);

}  // namespace frond
