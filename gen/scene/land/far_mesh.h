#pragma once

#include <vector>

#include "core/seed.h"
#include "land/far_land.h"
#include "model/surface.h"

namespace frond {

/// What the cameras of a film have of the far land. It is drawn once for all frames.
struct FarView {
  double from = 0, to = 2 * kPi;  ///< directions in view, radians: 0 toward +x, a quarter turn toward +z
  double pixel = 0.001;           ///< metres that a pixel is at 1 m; of a picture of at most 8.3 million
  double eye = 1.6;               ///< metres, the greatest height of a camera
  double aside = 0;               ///< metres from the middle to the farthest camera
  double pixels = 1e5;            ///< of a picture, 8.3 million at most: what is drawn grows with them

  bool holds(Vec2 at) const;  ///< whether that place is in view from the middle
};

/// All land of one cover.
struct FarPart {
  FarCover cover = FarCover::meadow;
  bool across = false;  ///< of fields: ploughed across the main direction
  Surface surface;
};

/// The land as a mesh on rays from the middle, in parts of one cover. Rows are some hundredths of their
/// distance apart, rays some pixels in the directions in view and far more elsewhere. What rises in front
/// of a camera hides land, which is left out. Woods are raised to a rough canopy.
std::vector<FarPart> far_mesh(const FarLand& land, const FarView& view, Seed seed);

}  // namespace frond
