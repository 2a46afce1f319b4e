#pragma once

#include <array>
#include <vector>

#include "land/far_mesh.h"

namespace frond {

/// Trees, hedges and houses of the far land: copies of a few shapes.
enum class FarKind : std::uint8_t { broadleaf, conifer, hedge, house };
inline constexpr int kFarKinds = 4;

/// One copy.
struct FarObject {
  FarKind kind = FarKind::broadleaf;
  int shape = 0;  ///< of those of its kind
  Vec3 foot{0};
  float turn = 0;  ///< radians about the vertical
  Vec3 size{1};    ///< factors of the shape
  int tint = 0;    ///< 0..kFarTints - 1
};
inline constexpr int kFarTints = 3;

/// The shapes of a kind; houses have the sizes of houses, all others the height 1.
std::vector<Surface> far_shapes(FarKind kind);

/// All that is larger than a few pixels in view: trees at the edges of woods, within near ones, in hedges,
/// about houses and singly on meadows; the nearest first where there are more than a picture of its size
/// needs.
std::vector<FarObject> far_objects(const FarLand& land, const FarView& view, Seed seed);

/// All that is drawn of the far land, the same in each frame of a film.
struct DistantTerrain {
  double from = 0;                                     ///< metres from the middle to where it begins
  Vec2 along{1, 0};                                    ///< main direction of the parcels
  std::vector<FarPart> parts;                          ///< the land
  std::array<std::vector<Surface>, kFarKinds> shapes;  ///< of each kind that there is any of
  std::vector<FarObject> objects;
};

DistantTerrain distant_terrain(const FarLandShape& shape, const GroundEdge& edge, const FarView& view,
                               Seed seed);

}  // namespace frond
