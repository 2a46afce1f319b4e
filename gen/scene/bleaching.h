#pragma once

#include "core/vec.h"

namespace frond {

// Shares of its light, 0..1, that neighbours leave to the skin of a coral: up to the first it is dead, at the
// second bleached, from the third on as in the open. povinc/frond_bleach.inc draws the same.
inline constexpr float kDeadLight = 0.28f, kPaleLight = 0.36f, kLivingLight = 0.52f;
inline constexpr Vec3 kBleachedLime(0.92f, 0.88f, 0.80f);  ///< the skeleton that shows through; linear
inline constexpr Vec3 kDeadTurf(0.62f, 0.55f, 0.30f);      ///< algae on what is dead; linear

/// What skin of a linear colour shows with so much of its light left.
Vec3 bleached(Vec3 color, float light);

}  // namespace frond
