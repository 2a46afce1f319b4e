#pragma once

#include "core/result.h"
#include "field/volume.h"

namespace frond {

/// A body built of equal cubes on the grid of the world. Only those of which a face shows.
struct Cubes {
  float side = 0.1f;                ///< metres
  std::vector<Cell> cell;           ///< a cube's middle is at cell * side
  std::vector<std::int32_t> node;   ///< of the skeleton, at the end of the segment that is nearest
  std::vector<std::uint8_t> shown;  ///< bits of the faces that show: 1 -x, 2 +x, 4 -y, 8 +y, 16 -z, 32 +z

  std::size_t size() const { return cell.size(); }
};

/// The cubes whose middles lie in the boughs, and those that the middle line of a bough passes: so branches
/// thinner than a cube hang together, face to face. Only voxel and limit of the options count.
Result<Cubes> cubes_of(const Boughs& boughs, const VolumeOptions& options);

/// The faces that show, crisp: each has corners of its own. Triangles 2 i and 2 i + 1 are of cube `cube[i]`.
Surface cubes_surface(const Cubes& cubes, std::vector<std::uint32_t>& cube);

}  // namespace frond
