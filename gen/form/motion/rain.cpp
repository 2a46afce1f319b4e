#include "motion/rain.h"

#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace frond {

namespace {

constexpr double kDrops = 8000;                                         // a cubic metre and millimetre
constexpr double kFastFall = 9.65, kSlowFall = 10.3, kFallGrows = 0.6;  // of the terminal speed
constexpr double kWetting = 0.15;                                       // mm that wet a surface

/// How fast drops become fewer with their diameter, 1/mm.
double drop_slope(double rate) { return 4.1 * std::pow(rate, -0.21); }

}  // namespace

double drop_density(double rate, double diameter) {
  return rate > 0 ? kDrops * std::exp(-drop_slope(rate) * diameter) : 0;
}

double drops_thicker(double rate, double diameter) {
  return rate > 0 ? drop_density(rate, diameter) / drop_slope(rate) : 0;
}

double drop_diameter(double rate, double least, double order) {
  return least - std::log(std::max(order, 1e-12)) / drop_slope(rate);
}

double terminal_speed(double diameter) {
  return std::max(0.1, kFastFall - kSlowFall * std::exp(-kFallGrows * diameter));
}

double drops_landing(double rate, double diameter) {
  if (rate <= 0) return 0;
  double k = drop_slope(rate), slow = k + kFallGrows;
  return kDrops * (kFastFall / k * std::exp(-k * diameter) - kSlowFall / slow * std::exp(-slow * diameter));
}

double rain_extinction(double rate) {
  // The integral of 2 pi/4 D^2 N(D); square millimetres in a cubic metre.
  return rate > 0 ? 1e-6 * kPi * kDrops / std::pow(drop_slope(rate), 3) : 0;
}

double rain_clouds(double rate) { return smooth_step(0.0, 1.0, rate); }

double wetness(double fallen) { return 1 - std::exp(-fallen / kWetting); }

}  // namespace frond
