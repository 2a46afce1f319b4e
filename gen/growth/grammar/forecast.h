#pragma once

#include "grammar/derive.h"

namespace frond {

/// Predicted size of a derivation.
struct Forecast {
  enum class Kind { exact, expected, extrapolated, at_least };

  Kind kind = Kind::exact;
  double modules = 0;   ///< of the last word
  double segments = 0;  ///< that the turtle draws for the last word
  double bytes = 0;     ///< of the last word
  double work = 0;      ///< modules of all words up to it
  int small_steps = 0;  ///< number of first steps that are fast: few modules in total and in their last word
  int passes_at = -1;   ///< first step whose word passes the limits; -1: none
  double passes_with = 0;  ///< modules at that step, or segments if these are more
  Errors trouble;          ///< other reasons that will stop the derivation, where known
};

/// Predicts a derivation: exactly by the growth matrix if each symbol has one rule that always applies; as
/// the mean if rules have fixed weights; otherwise from a dry run until a word has a million modules. If the
/// last step exceeds the limits, the figures are lower bounds.
Forecast forecast(const Grammar& grammar, int steps, Seed seed, const Limits& limits = {});

/// The reason to refuse the derivation: its trouble, or the figure and the step at which it exceeds the
/// limits. Empty if it is not refused.
Errors refuse(const Forecast& forecast, const Limits& limits);

/// Whether the growth matrix holds for the grammar, which makes a forecast cheap.
bool has_growth_matrix(const Grammar& grammar);

}  // namespace frond
