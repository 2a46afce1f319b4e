#pragma once

#include <functional>
#include <vector>

#include "land/mountain_cover.h"
#include "settings/lawn.h"

namespace frond {

/// The land of a forest, as needed for its floor.
struct ForestLand {
  std::function<double(Vec2)> height;  ///< metres, at x, z
  std::function<double(Vec2)>
      path;  ///< metres to the edge of the path, negative on it; large if there is none
  std::function<double(Vec2)> moss = {};  ///< factor of the share of moss; empty: 1
};

/// How green the floor is at a point, 0..1: moss grows above 0.5. It prefers level ground and avoids the
/// path; over level land its share is `Forest::moss`.
double mossiness(const ForestLand& land, double share, Vec2 at, Seed seed);

/// Sets `uv` for the texture of the floor: u is metres to the edge of the path, -4..8, v the mossiness.
void mark_floor(Surface& floor, const ForestLand& land, double moss, Seed seed);

/// The cover of mountains there, see mountain_cover_at().
double mountain_cover_on(const ForestLand& land, const AltitudeLines& lines, Vec2 at);

/// Sets `uv` for the texture of mountains: v is the cover, u how far aside of the path's middle a place lies,
/// in halves of its width, -9 on its left .. 9; 9 where there is none. It is signed, so that triangles wider
/// than the path show it; to that end it goes straight on behind both ends.
void mark_mountain(Surface& floor, const ForestLand& land, const AltitudeLines& lines,
                   const std::vector<Vec2>& path, double width);

/// Litter on a forest's floor: leaves and twigs, and cushions of moss.
struct ForestCover {
  std::vector<Surface> litter, moss;
  std::vector<Patch> litter_patches, moss_patches;
};

/// Places leaves, twigs and moss wherever the camera comes near during the film; fewer on the path.
ForestCover strew_floor(const Film& film, const Camera& camera, const ForestLand& land, double moss,
                        Seed seed);

/// The colour of fallen leaves at a time of the year: bright when they have just come down, dark by summer.
Color litter_at(const Color& mean, double year);

}  // namespace frond
