#pragma once

#include <array>

#include "core/vec.h"
#include "model/surface.h"

namespace frond {

/// A squared piece of timber or stone about the origin, its edges rounded.
struct Block {
  Vec3 size{1};         ///< metres along x, y and z, each > 0
  float bevel = 0.01f;  ///< metres, radius of the edges; held to 0.45 of the least size
  std::array<int, 3> parts{
      1, 1, 1};  ///< in how many parts its faces are cut along each axis, so that it can be bent
};

/// The block as a closed mesh without `uv`.
Surface block_surface(const Block& block);

/// Moves each vertex to where `place` takes it and sets the normals anew. `place` must keep right hands
/// right.
template <class Place>
void bend(Surface& surface, const Place& place) {
  for (Vec3& p : surface.position) p = place(p);
  set_normals(surface);
}

/// What the triangles enclose, cubic metres; negative where they run the wrong way round.
double volume(const Surface& surface);

/// A colour so many times as bright, and by a share warmer.
Color toned(const Color& color, double brightness, double warmth);

}  // namespace frond
