#pragma once

#include "rocks/blobs.h"

namespace frond {

inline constexpr Falloff kFalloffs[] = {Falloff::gaussian, Falloff::soft, Falloff::cubic};

}  // namespace frond
