#pragma once

#include "core/vec.h"

namespace frond {

/// A colour so many times as bright, and by a share warmer.
Color toned(const Color& color, double brightness, double warmth);

}  // namespace frond
