#include "motion/snowfall.h"

#include <cmath>

#include "core/vec.h"

namespace frond {

namespace {

constexpr double kMass = 0.073, kMassPower = 1.4;   // mg, of a flake of 1 mm
constexpr double kSpeed = 0.8, kSpeedPower = 0.16;  // m/s, the same
constexpr double kDropMass = kPi / 6;               // mg, of a drop of 1 mm

double flake_number(double rate) { return 3800 * std::pow(rate, -0.87); }
double flake_slope(double rate) { return 2.55 * std::pow(rate, -0.48); }

}  // namespace

double flakes_larger(double rate, double melted) {
  return rate > 0 ? flake_number(rate) / flake_slope(rate) * std::exp(-flake_slope(rate) * melted) : 0;
}

double flake_diameter(double melted) {
  return std::pow(kDropMass * melted * melted * melted / kMass, 1 / kMassPower);
}

double melted_diameter(double flake) { return std::cbrt(kMass * std::pow(flake, kMassPower) / kDropMass); }

double flake_speed(double melted) { return kSpeed * std::pow(flake_diameter(melted), kSpeedPower); }

double snowfall_extinction(double rate) {
  if (rate <= 0) return 0;
  // The integral of 2 pi/4 cover D^2 N(d), with D^2 in proportion to d to this power; square millimetres in a
  // cubic metre.
  double power = 6 / kMassPower, disc = flake_diameter(1);
  return 1e-6 * kPi / 2 * kFlakeCover * disc * disc * flake_number(rate) * std::tgamma(power + 1) /
         std::pow(flake_slope(rate), power + 1);
}

double snow_clouds(double rate) { return smooth_step(0.0, 0.3, rate); }

}  // namespace frond
