#pragma once

#include "core/result.h"
#include "field/volume.h"

namespace frond {

/// A body of equal cubes on the world's grid. Only cubes with a visible face.
struct Cubes {
  float side = 0.1f;                ///< metres
  std::vector<Cell> cell;           ///< a cube's middle is at cell * side
  std::vector<std::int32_t> node;   ///< of the skeleton, at the end of the nearest segment
  std::vector<std::uint8_t> shown;  ///< bits of the faces that show: 1 -x, 2 +x, 4 -y, 8 +y, 16 -z, 32 +z

  std::size_t size() const { return cell.size(); }
};

/// The cubes whose middles are inside the boughs, and those crossed by the axis of a bough, so that branches
/// thinner than a cube stay connected, face to face. Of the options only voxel and limit are used.
Result<Cubes> cubes_of(const BranchVolume& boughs, const VolumeOptions& options);

/// The visible faces with sharp edges: each has its own corners. Triangles 2 i and 2 i + 1 belong to cube
/// `cube[i]`.
Surface cubes_surface(const Cubes& cubes, std::vector<std::uint32_t>& cube);

}  // namespace frond
