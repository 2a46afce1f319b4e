#pragma once

#include "core/vec.h"

namespace frond {

/// The brightness that a channel of sRGB stands for, 0 to 1 (IEC 61966-2-1).
double linear(double channel);

/// The channel of sRGB that stands for a brightness.
double encoded(double light);

/// A colour as light is reckoned with.
Vec3 linear(const Color& color);

}  // namespace frond
