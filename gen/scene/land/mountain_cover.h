#pragma once

#include "core/vec.h"

namespace frond {

/// Where woods and snow end on mountains, metres of altitude, and the direction x, z of the shaded side, of
/// length 1, or 0 where all sides are alike.
struct AltitudeLines {
  double trees = 1800, snow = 1e5;
  Vec2 shaded{0};
};

/// A place on a mountain.
struct MountainPlace {
  Vec2 at{0};
  double height = 0;  ///< metres of altitude
  Vec2 slope{0};      ///< rise over run
  double hollow = 0;  ///< rise over run by which the land around is higher: gullies above 0, ridges below
};

/// What covers mountains, as a number between these, with all that lies between two of them as a mixture:
/// floors of woods, dwarf shrubs, grass, scree, bare rock and snow. Altitude, slope and curvature choose, as
/// in the Alps (Ellenberg 2010): heath begins at the tree line, grass ends some 400 m above it, no soil holds
/// on slopes of more than 42 degrees, scree lies in gullies and below faces at its angle of rest of 35
/// degrees, and snow slides from where it is steeper than 50 degrees, but stays long in couloirs and shade.
namespace mountain_cover {
inline constexpr double kWood = 0, kHeath = 0.2, kGrass = 0.4, kScree = 0.6, kRock = 0.8, kSnow = 1;
}
double mountain_cover_at(const AltitudeLines& lines, const MountainPlace& place);

}  // namespace frond
