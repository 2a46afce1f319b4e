#include "grove/age.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace frond {

namespace {

/// The number of growth cycles of a living tree at an age in years; a whole number once its youth is over.
double cycles_alive(const Species& s, double years) {
  assert(s.pace > 0 && s.youth > 0 && years >= 0);
  if (years <= s.youth) return s.pace * years;
  return std::round(s.pace * s.youth * (1 + std::log(years / s.youth)));
}

}  // namespace

int growth_cycles(const Species& s, double years) {
  double lived = std::min(years, s.lifespan);
  double cycles = std::round(cycles_alive(s, lived)) + std::round(years - lived);
  return static_cast<int>(std::max(1.0, cycles));
}

double cycle_at_age(const Species& s, double years) {
  double lived = std::min(years, s.lifespan), grown_up = std::max(lived / s.youth, 1.0);
  return s.pace * std::min(lived, s.youth) + s.pace * s.youth * std::log(grown_up) + years - lived;
}

double age_at_cycle(const Species& s, double cycle) {
  double young = s.pace * s.youth, years = cycle / s.pace;
  if (cycle > young) years = s.youth * std::exp(cycle / young - 1);
  return years <= s.lifespan ? years : s.lifespan + cycle - cycle_at_age(s, s.lifespan);
}

Species in_cycles(const Species& s) {
  Species counted = s;
  counted.maturity = cycles_alive(s, s.maturity);
  counted.lifespan = growth_cycles(s, s.lifespan);
  counted.pace = 1, counted.youth = std::numeric_limits<double>::max();
  return counted;
}

}  // namespace frond
