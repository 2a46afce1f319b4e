#pragma once

#include "core/vec.h"

namespace frond {

/// The linear brightness of a channel value in sRGB, both 0 to 1 (IEC 61966-2-1).
double linear(double channel);

/// The sRGB channel value of a linear brightness.
double encoded(double light);

/// A colour as linear light.
Vec3 linear(const Color& color);

}  // namespace frond
