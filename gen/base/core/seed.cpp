#include "core/seed.h"

#include <cmath>
#include <numbers>

namespace frond {

double Seed::normal() const {
  // Box and Muller 1958; 1 - unit() keeps the logarithm finite.
  double radius = std::sqrt(-2.0 * std::log(1.0 - child(0).unit()));
  return radius * std::cos(2.0 * std::numbers::pi * child(1).unit());
}

}  // namespace frond
