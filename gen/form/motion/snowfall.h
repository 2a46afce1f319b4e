#pragma once

// Snowfall as a law: how many flakes of which size are in the air, how fast they fall, and how much light
// they take. `rate` is mm/h of the water that they are: 0.3 light snow, 1 steady, 3 heavy. Flakes are told by
// `melted`, the diameter in mm of the drop that one melts to.

namespace frond {

/// Flakes in a cubic metre that are larger than `melted`: the integral of 3800 R^-0.87 exp(-2.55 R^-0.48 d)
/// by mm (Gunn and Marshall 1958). 0 where it does not snow.
double flakes_larger(double rate, double melted);

/// The largest diameter of a flake, mm: that of loose aggregates of dendrites, whose mass in mg is
/// 0.073 D^1.4 (Locatelli and Hobbs 1974).
double flake_diameter(double melted);

/// The `melted` of a flake of that diameter, mm.
double melted_diameter(double flake);

/// Metres a second at which a flake falls in still air: 0.8 D^0.16 (the same).
double flake_speed(double melted);

/// The share of the disc about a flake that it covers.
inline constexpr double kFlakeCover = 0.3;

/// Light that is lost along a metre, by twice the cross sections of the flakes. It gives a visibility of 500
/// m at 1 mm/h: observers call snow moderate where they see 400 to 800 m (Federal Meteorological Handbook 1).
double snowfall_extinction(double rate);

/// Share of the sky that the clouds of such a rate take, 0..1: all of it from 0.3 mm/h on.
double snow_clouds(double rate);

}  // namespace frond
