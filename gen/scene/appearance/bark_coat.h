#pragma once

#include "appearance/leaf_look.h"
#include "images/bark.h"

namespace frond {

/// Bark as a picture: branches are meshes then, and the picture repeats a whole number of times round them.
struct BarkCoat {
  BarkImage image;
  FileName photo;       ///< a photograph of bark, from which `wrap` and `aspect` follow
  double tall = 0.5;    ///< metres along a branch that it shows
  double wrap = 0.6;    ///< metres round a branch covered by one width of the picture
  double aspect = 2;    ///< height of the picture relative to its width
  int pixels = 512;     ///< its width
  double relief = 1;    ///< of the bumps, 0 none
  double furrow = 0.3;  ///< depth cut into the mesh when the camera is near, as a share of a ridge's width
  double facet = 0.03;  ///< metres, about the width of a side of the mesh
  double moss = 0;      ///< 0 none .. 1: thickness at the foot
  double moss_height = 1.2;               ///< metres, the highest moss
  Color tone{0.6343f, 0.6012f, 0.5564f};  ///< by which tints of copies turn the picture's colours
  double twigs = 0;  ///< metres; branches that begin thinner than this are sweeps, without a picture
};

/// File names of its two pictures: colour and height.
std::string bark_color_name(const BarkCoat& coat);
std::string bark_height_name(const BarkCoat& coat);

/// Takes a photograph that a preset names, as `tall` as that says.
Errors load_bark_photo(const NamedFile& file, BarkCoat& coat);

/// The seed of all bark pictures.
inline Seed bark_seed() { return Seed{11}; }

/// Both pictures.
Drawing bark_drawing(const BarkCoat& coat);

}  // namespace frond
