#pragma once

#include <optional>

#include "land/mountain.h"
#include "settings/lawn.h"
#include "settings/scene_setup.h"
#include "settings/sky.h"

namespace frond {

/// An outdoor scene by day, in summer by default.
struct Meadow {
  Vec3 sun{0.5f, 0.75f, 0.6f};  ///< toward the sun, if there is no hour
  Vec3 moon = SkyShape{}.moon;  ///< toward the moon
  std::optional<Animated<double>> hour;
  Moment when;                           ///< its own hour counts for nothing
  double turbidity = 2.5;                ///< see SkyShape
  std::optional<Color> zenith, horizon;  ///< of the sky overhead and at the horizon; none: computed
  Color grass{0.39f, 0.46f, 0.17f};
  double haze = 6000;    ///< metres in which two thirds of a colour are lost
  double clouds = 0.45;  ///< 0 none .. 1 overcast
  std::optional<MountainShape> mountain;
  LawnShape lawn;
};

/// The sky of a scene's meadow with that sun, overcast where it rains at the beginning.
Sky sky_over(const SceneSetup& setup, Vec3 sun, double exposure);

/// The sky of each setting that has one, as the camera exposes it.
Sky meadow_sky(const SceneSetup& setup);
Sky garden_sky(const SceneSetup& setup);
Sky forest_sky(const SceneSetup& setup);

}  // namespace frond
