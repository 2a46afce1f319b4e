#pragma once

#include <algorithm>

#include "core/vec.h"

namespace frond {

// Colours as painted pictures mix them.

inline Color mix(const Color& a, const Color& b, double t) {
  return mixed(a, b, static_cast<float>(std::clamp(t, 0.0, 1.0)));
}

inline Color shaded(const Color& c, double by) {
  auto f = static_cast<float>(by);
  return {c.red * f, c.green * f, c.blue * f};
}

}  // namespace frond
