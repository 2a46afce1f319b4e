#pragma once

#include <functional>

#include "model/surface.h"

namespace frond {

/// How a smooth mesh with `uv` is raised.
struct Relief {
  double depth = 0.01;  ///< metres from height 0 to height 1; the mesh itself is at 1
  double facet =
      0.003;  ///< metres, about how wide the small triangles are; as long as the large ones ask for
  std::function<float(Vec2)> height;            ///< 0..1, by uv
  std::function<float(Vec3, Vec3)> share = {};  ///< 0..1 of the depth, by place and normal; smooth
};

/// Cuts triangles where the share is above 0 into small ones, round as the normals say, and lets them in by
/// the heights. What lies beside stays as it is, so that no gap opens where the share goes to 0.
Surface raised(const Surface& smooth, const Relief& relief);

}  // namespace frond
