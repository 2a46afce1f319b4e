#pragma once

#include "settings/lawn.h"

namespace frond {

/// A summer's day outdoors.
struct Meadow {
  Color zenith{0.22f, 0.45f, 0.78f};   ///< of the sky above
  Color horizon{0.80f, 0.88f, 0.93f};  ///< of the sky far off, and of the haze
  Color grass{0.39f, 0.46f, 0.17f};
  Vec3 sun{0.5f, 0.75f, 0.6f};  ///< toward the sun
  double haze = 6000;           ///< metres in which two thirds of a colour are lost
  double clouds = 0.45;         ///< 0 none .. 1 overcast
  LawnShape lawn;
};

}  // namespace frond
