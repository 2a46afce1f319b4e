#pragma once

#include <algorithm>
#include <cmath>

namespace frond {

/// How often something turns or swings, at least once, in a film of `seconds` that repeats: the whole number
/// nearest to `rate` times as long, `rate` being turns a second.
inline double whole_turns(double rate, double seconds) { return std::max(1.0, std::round(rate * seconds)); }

/// That as turns a second; the rate itself where the film does not repeat, `seconds` being 0.
inline double looping_rate(double rate, double seconds) {
  return seconds > 0 ? whole_turns(rate, seconds) / seconds : rate;
}

}  // namespace frond
