#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace frond {

/// Which triangles of a mesh look inward, and are to be turned over: those of closed pieces that enclose
/// their volume from behind, as after a mirroring. A piece inside the box of a larger one, which may be a
/// hollow in it, is turned over if that one is. Pieces hang together by their vertices, or, where they are
/// open so, by vertices at one place. Open pieces stay as they are.
std::vector<char> inward(std::span<const Vec3> position,
                         std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace frond
