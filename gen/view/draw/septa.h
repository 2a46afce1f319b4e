#pragma once

#include <vector>

#include "draw/polyps.h"

// The septa of stony corals: placements of one shape on the walls between their valleys, of those that are
// large enough to be seen.

namespace frond {

/// Where a septum runs down a wall. It keeps its triangle, so the skin carries it along as it grows.
struct SeptumPlace {
  SurfacePoint at;   ///< half way up the wall
  Vec2 uphill{0};    ///< up the wall, as shares of two sides of the triangle; as long as the wall is wide
  float steep = 0;   ///< sine of the wall's angle
  float across = 0;  ///< metres of wall, when all has grown
};

/// Those of each of an organism's solids, all its life.
using SeptumPlaces = std::vector<std::vector<SeptumPlace>>;
SeptumPlaces septum_places(const Solids& solids);

/// The septa of one body at a time, in the space of that body. Those that face away, or that are too small to
/// be seen from `eye`, are left out.
struct DrawnSepta {
  const Material* material = nullptr;  ///< of the body
  Vec3 position{0};                    ///< of the body
  Quat turn{1, 0, 0, 0};
  Vec3 scale{1};
  float front = 1;                     ///< 0..1, how far the body has grown
  std::vector<glm::mat3> frames = {};  ///< of each: up the wall's foot, outward, along the ridge; the shape
                                       ///< is 1 wide, high and thick
  std::vector<Vec3> positions = {};    ///< metres
};

std::vector<DrawnSepta> drawn_septa(const Solids& solids, const SeptumPlaces& places, const Growth& growth,
                                    double time, const Eye& eye);

}  // namespace frond
