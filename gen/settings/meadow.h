#pragma once

#include <optional>

#include "land/mountain.h"
#include "settings/lawn.h"
#include "settings/sky.h"
#include "settings/stage.h"

namespace frond {

/// A day outdoors, in summer where the preset does not say.
struct Meadow {
  Vec3 sun{0.5f, 0.75f, 0.6f};  ///< toward the sun, where there is no hour
  std::optional<double> hour;   ///< of the moment below
  Moment when;
  double turbidity = 2.5;                ///< see SkyShape
  std::optional<Color> zenith, horizon;  ///< of the sky above and far off, in place of their own
  Color grass{0.39f, 0.46f, 0.17f};
  double haze = 6000;    ///< metres in which two thirds of a colour are lost
  double clouds = 0.45;  ///< 0 none .. 1 overcast
  double hills = 1;      ///< factor of the heights of hills and woods far off
  std::optional<MountainShape> mountain;
  LawnShape lawn;
};

/// The sky of a meadow with the sun there.
Sky sky_over(const Meadow& meadow, Vec3 sun, double exposure);

/// The sky over each of the settings that have one, as the camera exposes it.
Sky meadow_sky(const Stage& stage);
Sky garden_sky(const Stage& stage);
Sky forest_sky(const Stage& stage);

}  // namespace frond
