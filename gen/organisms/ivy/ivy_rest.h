#pragma once

#include <span>
#include <vector>

#include "creeping/host.h"

namespace frond {

/// What leaves lie on.
struct Support {
  const Host& host;
  const GroundHeight& ground;
};

/// The blades of a leaf or a sprig as places about `apart` from each other, in units of the form, by which it
/// feels what is under it. Of `surface` those vertices count whose `uv` is that of a blade.
std::vector<Vec3> feelers_of(const Surface& surface, float apart);

/// A leaf where it stands.
struct Rest {
  Vec3 foot{0};
  Quat turn{1, 0, 0, 0};
};

/// Turns a leaf of a size (metres a unit) about its foot, and slides it by up to `slide` units toward `out`,
/// as little as that takes, until no feeler is in the host or the ground. False where it finds no rest.
bool lie_on(const Support& under, std::span<const Vec3> feelers, float size, float slide, Vec3 out,
            Rest& rest);

}  // namespace frond
