#pragma once

#include "grammar/derive.h"

namespace frond {

/// How large a derivation will be, without making it.
struct Forecast {
  enum class Kind { exact, expected, extrapolated, at_least };

  Kind kind = Kind::exact;
  double modules = 0;      ///< of the last word
  double segments = 0;     ///< that the turtle draws for it
  double bytes = 0;        ///< of the last word
  double work = 0;         ///< modules of all words up to it
  int small_steps = 0;     ///< so many of the steps take a moment: few modules in all, and in the last word
  int passes_at = -1;      ///< first step whose word passes the limits; -1: none
  double passes_with = 0;  ///< modules at that step, or segments where they are more
  Errors trouble;          ///< what else will stop the derivation, where that showed
};

/// Predicts a derivation: exactly by the growth matrix where each symbol has one rule that always applies, as
/// the mean where rules draw lots with fixed weights, and otherwise from a dry run of at most 100,000
/// modules. Where its last step makes more than it may, the figures are what there is at least.
Forecast forecast(const Grammar& grammar, int steps, Seed seed, const Limits& limits = {});

/// Why the derivation is refused: its trouble, or the figure and the step at which it passes the limits.
/// Empty when it is not.
Errors refuse(const Forecast& forecast, const Limits& limits);

/// Whether the growth matrix holds for the grammar, which makes a forecast cheap.
bool has_growth_matrix(const Grammar& grammar);

}  // namespace frond
