#pragma once

#include <array>

#include "core/vec.h"
#include "images/raster.h"

namespace frond {

/// Linear light or directions, rows from the top down.
using VecGrid = PixelGrid<Vec3>;

/// A part of a picture, of so much light where it is white.
VecGrid part_of(const LinearRaster& raster, double white, int left, int top, int wide, int high);

/// Gives pixels that nothing was seen at, which are black, the light of the nearest in their row or column.
void fill_black(VecGrid& light);

/// Makes a picture go on over its edges: of so many pixels, the last ones of a larger one are blended with
/// the first, so that the contrast stays (Heitz & Neyret 2018, equation 4).
VecGrid seamless(const VecGrid& larger, int wide, int high);

/// Directions towards the lamps of the photometry: three of them round the view, 45 degrees aslant. x to the
/// right, y up, z to the eye.
std::array<Vec3, 3> lamps();

/// The normals of what is seen in ambient light, and in that and the light of one lamp each (Woodham 1980).
VecGrid normals_of(const VecGrid& ambient, const std::array<VecGrid, 3>& lit);

/// A picture of the normals, 0..255 standing for -1..1.
Raster normal_raster(const VecGrid& normals);
/// A picture of linear colours, in sRGB.
Raster color_raster(const VecGrid& light);

/// The roughness in green, of half as many pixels: where normals differ within a pixel a surface is rougher
/// by as much (Toksvig 2005). `rough` is that of a smooth one, 0..1.
Raster roughness_of(const Raster& normals, double rough);

}  // namespace frond
