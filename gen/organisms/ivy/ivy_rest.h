#pragma once

#include <span>
#include <vector>

#include "creeping/host.h"

namespace frond {

/// The surfaces that leaves lie on.
struct Support {
  const Host& host;
  const GroundHeight& ground;
};

/// Points on the blades of a leaf or sprig, about `apart` from each other, in units of the form, used to test
/// contact. Only vertices of `surface` with a blade's `uv` count.
std::vector<Vec3> feelers_of(const Surface& surface, float apart);

/// The position of a leaf.
struct Rest {
  Vec3 foot{0};
  Quat turn{1, 0, 0, 0};
};

/// Rotates a leaf (`size`: metres per unit) about its foot, and moves it by up to `slide` units toward `out`,
/// as little as possible, until no feeler is inside the host or the ground. False if that fails.
bool lie_on(const Support& under, std::span<const Vec3> feelers, float size, float slide, Vec3 out,
            Rest& rest);

}  // namespace frond
