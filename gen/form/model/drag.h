#pragma once

#include <algorithm>
#include <cmath>

// The drag of the wind on wood and leaves: of the storms that break trees and of the wind that they sway in.

namespace frond {

inline constexpr float kAir = 1.2f;       ///< kg/m3
inline constexpr float kBareDrag = 1.0f;  ///< drag coefficient of a bare branch across the wind
inline constexpr float kLeafDrag =
    0.25f;  ///< of leaves, which fold together and hide each other (Vogel 1989)
inline constexpr float kSunlit =
    0.35f;  ///< of the leaf area, what meets the wind or the snow: leaves stand in layers
inline constexpr float kGiving = 0.7f;  ///< leaves give way: drag grows with the speed to 2 less this (Vogel)
inline constexpr float kCalm = 10;      ///< metres a second up to which they do not

/// The wind at a height above ground, metres a second; `speed` is that at ten metres, at which winds are
/// told.
inline float wind_at(float height, float speed) {
  return speed * std::pow(std::clamp(height / 10, 0.02f, 2.0f), 0.2f);
}

}  // namespace frond
