#pragma once

#include <array>
#include <vector>

#include "creeping/triangle_surface.h"

namespace frond {

/// The surfaces that leaves lie on.
struct Support {
  const TriangleSurface& host;
  const GroundHeight& ground;
};

/// How the blades of a leaf or sprig feel what is near, in units of the form.
struct Feelers {
  std::vector<Vec3> points;                ///< all over them
  std::vector<std::array<Vec3, 2>> edges;  ///< of all their triangles, each once
};

/// Those of a surface, points about `apart` from each other. Only what has a blade's `uv` counts.
Feelers feelers_of(const Surface& surface, float apart);

/// The position of a leaf.
struct Rest {
  Vec3 foot{0};
  Quat turn{1, 0, 0, 0};
};

/// Rotates a leaf (`size`: metres per unit) about its foot, and moves it by up to `slide` units toward `out`,
/// as little as possible, until no point is inside the host or the ground and no edge goes through the host.
/// False if that fails.
bool lie_on(const Support& under, const Feelers& feelers, float size, float slide, Vec3 out, Rest& rest);

}  // namespace frond
