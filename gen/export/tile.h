#pragma once

#include <functional>
#include <vector>

#include "core/result.h"
#include "dress/bark.h"
#include "dress/skin.h"
#include "images/raster.h"
#include "model/model.h"
#include "model/solid.h"

namespace frond {

/// What is drawn at one place of a picture: a colour as light is reckoned with, and a height of 0 to 1.
struct Dab {
  DVec3 color{0};
  double height = 0.5;
};

/// A picture of a surface as arrays, rows from the top down.
struct Tile {
  Grid height;
  std::vector<DVec3> color;  ///< linear
  double metres = 1;         ///< of a matter: that it is wide and high where it lies
  double strength = 6;       ///< of the relief, in pixels
};

/// Draws a picture; (u, v) are 0..1 with v from the foot up.
Tile tile_of(int width, int height, const std::function<Dab(double u, double v)>& spot);

/// What POV-Ray draws by patterns in space, as a picture that fits on itself in both directions.
Tile matter_tile(const Material& material, int pixels);
Tile skin_tile(const Skin& skin, int pixels);
Tile palm_tile(const Bark& bark, int pixels);
/// How many metres such a picture is wide and high.
double skin_metres(const Skin& skin);
double palm_metres(const Bark& bark);

/// A face of a cube, its edges dark.
Tile cube_tile(const Color& color, int pixels);

/// A vessel with its bands, u once round, so many pixels wide.
Tile vessel_tile(const Material& material, int pixels);
/// Where on that picture a place on a vessel lies: 0 the foot .. 1 the lip .. 2 the bottom inside.
float on_vessel(float along);

/// A leaf that has no picture of its own: u from its foot to its tip, v across.
Tile tissue_tile(Tissue tissue, const Color& color, const Color& second, int pixels);

/// The mean of a tile's colours.
Color mean_color(const Tile& tile);

/// The three pictures of a material.
struct Pictures {
  Raster colors, normals, roughness;
};
Pictures pictures_of(const Tile& tile, double rough);

/// The roughness alone, of half as many pixels: deep places are rougher than `rough` says, 0..1.
Raster roughness_of(const Grid& height, double rough);

}  // namespace frond
