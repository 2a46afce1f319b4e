#pragma once

#include <memory>

#include "core/seed.h"
#include "core/vec.h"
#include "images/raster.h"
#include "model/bark.h"

namespace frond {

/// The picture of a bark. It tiles in both directions: round the branch and along it.
struct BarkImage {
  BarkPattern pattern = BarkPattern::furrowed;
  Color color{0.45f, 0.38f, 0.31f};   ///< on the ridges
  Color second{0.17f, 0.13f, 0.10f};  ///< in furrows, cracks and bands
  Color lichen{0.55f, 0.58f, 0.42f};
  double lichens = 0.15;  ///< share of the bark covered by lichens, 0..1
  int ridges = 9;         ///< number round the picture, > 0
  double stretch = 5;     ///< length of features relative to their width, > 0
  double warp = 1;        ///< how far ridges wander, 0 straight .. 2
  double depth = 1;       ///< of furrows, 0 .. 1
  double knots = 0;       ///< average number of scars of fallen branches per square of the picture's width
  double lenticels = 0;   ///< share of the possible positions of pores that have one, 0..1
  std::shared_ptr<const Raster> photo =
      {};  ///< a photograph as a tile, shown instead of all of that but `depth`
};

/// Height, 0 deep .. 1 high, and tone, 0 second colour .. 1 first colour. u runs round the branch, v along
/// it.
struct BarkMaps {
  Grid height, tone;
};
BarkMaps bark_maps(const BarkImage& bark, int width, int height, Seed seed);

/// Unit normals from the gradient of the height, as colours: 0.5 + n / 2; `strength` is the height 1 in
/// pixels.
Raster normal_picture(const Grid& height, double strength);

/// The colours of a bark without lighting, a little darker in deep places.
Raster bark_colors(const BarkImage& bark, const BarkMaps& maps, Seed seed);

/// Colours lit from the upper left by the normals: for far trees and for previews.
Raster lit_picture(const Raster& colors, const Raster& normals);

/// A grid as grey levels.
Raster grey_picture(const Grid& grid);

}  // namespace frond
