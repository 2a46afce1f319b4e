#pragma once

#include <optional>

#include "core/vec.h"

// The sky by day and night: position and light of the sun, and light from all other directions.

namespace frond {

/// A moment on Earth, for the position of the sun.
struct Moment {
  double hour = 10;                  ///< summer time: the sun is highest at 13
  double day = 172;                  ///< of the year, 1 to 366; 172 is midsummer
  double latitude = 50 * kPi / 180;  ///< radians, north is positive
  double south = 0;  ///< radians; direction of south: 0 toward +z, positive to the right of it
};

/// Declination of the sun on a day of the year, radians (Spencer 1971).
double declination(double day);

/// Direction toward the sun, of length 1; below the horizon at night.
Vec3 sun_at(const Moment& when);

/// A colour as CIE x and y with the luminance Y.
struct Luminance {
  double Y = 0;  ///< kcd/m2
  double x = 0, y = 0;
};

/// Colour of a clear sky in a direction `theta` from the zenith and `gamma` from the sun, with the sun at
/// `sun` from the zenith, all radians, only gamma above a right angle (Preetham, Shirley and Smits 1999).
/// Turbidity 2 is clear mountain air, 6 is haze.
Luminance preetham(double theta, double gamma, double sun, double turbidity);

/// Transmission of sunlight through the air, per colour channel, for that height of the sun, radians.
Vec3 through_air(double height, double turbidity);

/// Parameters of a sky.
struct SkyShape {
  Vec3 sun{0, 1, 0};       ///< direction toward it, of any length
  double turbidity = 2.5;  ///< 1.7 to 10
  double clouds = 0;       ///< 0 none .. 1 overcast
  double exposure = 0;     ///< stops above the metered exposure
  /// Colours that replace the computed sky overhead and at the horizon; linear.
  std::optional<Vec3> zenith = {}, horizon = {};
  Vec3 moon{0.4f, 0.6f, -0.5f};  ///< direction toward it, of any length
  double overcast = 0;           ///< 0 none .. 1: how much of a rain cloud is before sun and sky
};

/// A sky as a camera exposes it: linear colours, as the brightness of a white matt surface.
struct Sky {
  explicit Sky(const SkyShape& shape);

  /// Light from a direction of length 1; below the horizon, that from just above it.
  Vec3 from(Vec3 direction) const;

  Vec3 sun;           ///< true direction toward it, of length 1
  Vec3 lamp;          ///< direction toward the source of shadows: sun, afterglow or moon; above the horizon
  Vec3 lamplight{0};  ///< light of that source
  Vec3 zenith, horizon;                ///< mean colours of the sky overhead and at the horizon
  Vec3 glow{0};                        ///< additional light of the sky close to the sun
  Vec3 cloud{0}, shade{0};             ///< of clouds: lit by the lamp, and in shadow underneath
  Vec3 cloudy_zenith, cloudy_horizon;  ///< as zenith and horizon, with clouds

 private:
  Vec3 day(Vec3 direction) const;   // kcd/m2
  Vec3 dusk(Vec3 direction) const;  // as exposed
  Vec3 rain_cloud(double height) const;
  void light_clouds(double clouds);

  double turbidity_, height_;  // of the sun, radians
  float stops_, overcast_, metered_ = 1, twilight_ = 0, dim_ = 1;
  Vec3 tint_low_{1}, tint_high_{1};
};

}  // namespace frond
