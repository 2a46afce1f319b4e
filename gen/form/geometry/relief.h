#pragma once

#include <functional>

#include "model/surface.h"

namespace frond {

/// The relief that is cut into a smooth mesh with `uv`.
struct Relief {
  double depth = 0.01;  ///< metres from height 0 to height 1; the mesh itself is at 1
  double facet =
      0.003;  ///< metres, about the width of the small triangles; their length follows the large ones
  std::function<float(Vec2)> height;            ///< 0..1, by uv
  std::function<float(Vec3, Vec3)> share = {};  ///< 0..1 of the depth, by place and normal; smooth
};

/// Subdivides triangles where the share is above 0, rounded by the normals, and lowers them by the heights.
/// Neighbouring parts stay unchanged, so that no gap opens where the share goes to 0.
Surface raised(const Surface& smooth, const Relief& relief);

}  // namespace frond
