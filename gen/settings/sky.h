#pragma once

#include <optional>

#include "core/vec.h"

// The sky by day and night: where the sun stands, what it gives, and what comes from everywhere else.

namespace frond {

/// A moment on Earth, by the sun.
struct Moment {
  double hour = 10;                  ///< by the clock of summer: the sun stands highest at 13
  double day = 172;                  ///< of the year, 1 to 366; 172 is midsummer
  double latitude = 50 * kPi / 180;  ///< radians, north is positive
  double south = 0;                  ///< radians; where south is: 0 toward +z, to the right from there
};

/// Radians that the sun stands north of the equator on a day of the year (Spencer 1971).
double declination(double day);

/// Toward the sun, of length 1; below the horizon at night.
Vec3 sun_at(const Moment& when);

/// A colour as CIE x and y with the luminance Y.
struct Luminance {
  double Y = 0;  ///< kcd/m2
  double x = 0, y = 0;
};

/// A clear sky in a direction `theta` from the zenith and `gamma` from the sun, which stands `sun` from the
/// zenith, all radians, none but gamma above a right angle (Preetham, Shirley and Smits 1999). Turbidity 2 is
/// clear mountain air, 6 a haze.
Luminance preetham(double theta, double gamma, double sun, double turbidity);

/// What of red, green and blue sunlight comes through the air when the sun stands so high, radians.
Vec3 through_air(double height, double turbidity);

/// What a clear sky without its sun gives to level ground, klx (IES Lighting Handbook).
double diffuse_light(double height);

/// What a sky is made from.
struct SkyShape {
  Vec3 sun{0, 1, 0};       ///< toward it, of any length
  double turbidity = 2.5;  ///< 1.7 to 10
  double clouds = 0;       ///< 0 none .. 1 overcast
  double exposure = 0;     ///< stops more than a meter says
  /// Colours that the sky above and far off has instead of its own; linear.
  std::optional<Vec3> zenith = {}, horizon = {};
};

/// A sky as a camera exposes it: linear colours, of light as a white matt surface shows it.
struct Sky {
  explicit Sky(const SkyShape& shape);

  /// What comes from a direction of length 1; below the horizon, what comes from just above it.
  Vec3 from(Vec3 direction) const;

  Vec3 sun;                 ///< toward it as it stands, of length 1
  Vec3 lamp;                ///< toward what casts shadows: sun, afterglow or moon; above the horizon
  Vec3 lamplight{0};        ///< what it gives
  Vec3 zenith, horizon;     ///< means of the sky above and all round
  Vec3 glow{0};             ///< what the sun adds to the sky close round it
  Vec3 cloud{0}, shade{0};  ///< of clouds: where the lamp lights them, and underneath
  Vec3 cloudy_zenith, cloudy_horizon;  ///< as zenith and horizon, with the clouds before them

 private:
  Vec3 day(Vec3 direction) const;   // kcd/m2
  Vec3 dusk(Vec3 direction) const;  // as exposed
  void light_clouds(double clouds);

  double turbidity_, height_;  // of the sun, radians
  float stops_, metered_ = 1, twilight_ = 0, dim_ = 1;
  Vec3 tint_low_{1}, tint_high_{1};
};

}  // namespace frond
