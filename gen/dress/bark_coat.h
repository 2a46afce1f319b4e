#pragma once

#include "dress/leaf_look.h"
#include "images/bark.h"

namespace frond {

/// A bark that lies on branches as a picture: they are meshes then, and the picture goes round them a whole
/// number of times.
struct BarkCoat {
  BarkImage image;
  double wrap = 0.6;  ///< metres round a branch that the picture is wide
  double aspect = 2;  ///< how much longer than wide it is
  int pixels = 512;   ///< its width
  double relief = 1;  ///< of the bumps, 0 none
  double furrow =
      0.3;  ///< depth that is let into the mesh where the eye is near, as a share of a ridge's width
  double facet = 0.03;       ///< metres, about the width of a side of the mesh
  double moss = 0;           ///< 0 none .. 1: how thick it grows at the foot
  double moss_height = 1.2;  ///< metres to which it comes up
  double twigs = 0;  ///< metres; branches that begin with a smaller radius are sweeps, without a picture
};

/// Names of its two pictures: colour and height.
std::string bark_color_name(const BarkCoat& coat);
std::string bark_height_name(const BarkCoat& coat);

/// What grows in all of them.
inline Seed bark_seed() { return Seed{11}; }

/// Both of them.
Drawing bark_drawing(const BarkCoat& coat);

}  // namespace frond
