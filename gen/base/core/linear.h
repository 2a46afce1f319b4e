#pragma once

#include "core/vec.h"

namespace frond {

/// The linear brightness of a channel value in sRGB, both 0 to 1 (IEC 61966-2-1).
double linear(double channel);

/// The sRGB channel value of a linear brightness.
double encoded(double light);

/// A colour as linear light, and back.
Vec3 linear(const Color& color);
Color srgb(Vec3 light);

}  // namespace frond
