#pragma once

#include <functional>
#include <vector>

#include "settings/lawn.h"

namespace frond {

/// The land of a forest, as its floor asks for it.
struct ForestLand {
  std::function<double(Vec2)> height;  ///< metres, at x, z
  std::function<double(Vec2)>
      path;  ///< metres to the edge of the path, below 0 on it; large where there is none
};

/// How green the floor is at a place, 0..1: moss grows above 0.5. It likes level ground and keeps from the
/// path; over level land the share of it is that of `Forest::moss`.
double mossiness(const ForestLand& land, double share, Vec2 at, Seed seed);

/// Tells the texture of the floor by its `uv` where path and moss are: u metres to the edge of the path,
/// -4..8, v the mossiness.
void mark_floor(Surface& floor, const ForestLand& land, double moss, Seed seed);

/// What lies on a forest's floor: leaves and twigs, and cushions of moss.
struct ForestCover {
  std::vector<Surface> litter, moss;
  std::vector<Patch> litter_patches, moss_patches;
};

/// Strews leaves, twigs and moss where the camera comes near over the film; fewer on the path.
ForestCover strew_floor(const Film& film, const Camera& camera, const ForestLand& land, double moss,
                        Seed seed);

}  // namespace frond
