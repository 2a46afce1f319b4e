#pragma once

#include <vector>

#include "core/seed.h"
#include "core/vec.h"

// The wind over the land: one field of gusts that the mean wind carries along unchanged (Taylor 1938).

namespace frond {

/// The wind of a scene.
struct Wind {
  double speed = 6;            ///< metres a second, the mean ten metres above the ground
  double gusts = 0.25;         ///< standard deviation of the speed, as a share of the mean
  Vec3 direction{1, 0, 0.3f};  ///< in which it blows; its vertical part is ignored
  bool loop = true;            ///< gusts repeat after the film
};

/// A storm that comes and goes in a film.
struct Gale {
  double time = 0;   ///< seconds, its height
  double lasts = 2;  ///< seconds from its height to where it is a third as strong, > 0
  double speed = 0;  ///< metres a second, the mean at its height
};

/// A part of the gusts: a plane wave, of which each place downwind has the same course later.
struct Gust {
  double rate = 0;   ///< radians a second
  Vec2 wave{0};      ///< radians a metre, along x and z
  double phase = 0;  ///< radians
  double share = 0;  ///< its amplitude, as a share of the mean speed
};

/// The wind at all places and times.
struct WindField {
  Vec3 along{1, 0, 0};  ///< level, of length 1
  double speed = 0;     ///< metres a second, the mean where there is no storm
  std::vector<Gust> gusts;
  std::vector<Gale> gales;
  double film_length = 0;  ///< seconds after which the gusts repeat; 0: they do not

  /// The mean speed at a time, metres a second.
  double mean(double time) const;
  /// By how much of the mean the speed is higher at a place, on either side of 0.
  double gust(Vec3 place, double time) const;
  /// The integral of gust() over time, seconds: by how much of the mean wind's way gusts have carried on what
  /// they blow about at a place, on either side of 0.
  double carried(Vec3 place, double time) const;
};

/// Gusts of the spectrum of von Karman (1948), n S(n) / s^2 = 4 x / (1 + 70.8 x^2)^(5/6) with x = n L / U:
/// here with L = 40 m, as near the ground, and as a sum of sixteen waves of 0.03 to 4 a
/// second. They keep the deviation that is asked for. Crests run across the wind at random slants, so that
/// gusts are about as wide as long. In a film that repeats each wave passes a whole number of times.
WindField wind_field(const Wind& wind, double film_length, Seed seed, std::vector<Gale> gales = {});

/// Speed of the wind near the ground, as a share of that ten metres up.
inline constexpr double kLowWind = 0.6;

/// The pressure of a wind, Pa, that counts for leaves: half of the density of air times the speed squared,
/// less as leaves fold together. They do so gradually here, up to the drag of Vogel (1989), see drag.h.
double drag_pressure(double speed);

/// The power of the speed that drag_pressure() grows with, 2 in light wind.
double drag_power(double speed);

}  // namespace frond
