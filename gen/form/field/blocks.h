#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "field/branch_volume.h"

namespace frond {

inline constexpr int kBlockSide = 8;
inline constexpr int kBlockVoxels = kBlockSide * kBlockSide * kBlockSide;

/// A position on the voxel grid: the middle of voxel (i, j, k) is that many voxels from the world's origin,
/// so that the grid is the same in each frame.
struct Cell {
  std::int32_t i = 0, j = 0, k = 0;
  auto operator<=>(const Cell&) const = default;
};

/// A cube of 8 x 8 x 8 voxels with the items near it.
struct VoxelBlock {
  std::uint64_t key;                 ///< encodes its position
  std::uint32_t first, forks, last;  ///< range in BlockList::item: its cones, and from `forks` on its forks
};

struct BlockList {
  std::vector<VoxelBlock> blocks;  ///< sorted by key
  std::vector<std::uint32_t> item;
};

/// All blocks within `band` of the surface, or just inside it, in a number of lists that does not depend on
/// the number of threads.
struct Blocks {
  float voxel = 0.01f, band = 0.03f;  ///< metres
  std::array<BlockList, 64> lists;

  std::size_t size() const;
};

/// The first voxel of the block with a key, and the key of the block that contains a voxel.
Cell block_origin(std::uint64_t key);
std::uint64_t block_key(Cell voxel);

/// The middle of a voxel, metres; and the voxel that contains a point.
Vec3 voxel_middle(Cell voxel, float size);
Cell voxel_at(Vec3 place, float size);

/// Whether all boughs fit on a grid of such voxels: within 8 million voxels of the origin.
bool fits_grid(const BranchVolume& boughs, float voxel);

/// Sorts cones and forks into the blocks near them.
Blocks gather_blocks(const BranchVolume& boughs, float voxel, float band);

/// The block that contains a voxel and its list, or nulls.
struct FoundBlock {
  const BlockList* list = nullptr;
  const VoxelBlock* block = nullptr;
};
FoundBlock find_block(const Blocks& blocks, Cell voxel);

/// The items of a block, its forks reduced to what matters in it and within a voxel round it.
void near_block(const BranchVolume& boughs, const Blocks& blocks, const FoundBlock& found, Nearby& near);

/// The middle of a cube of `side` voxels, and the largest distance of their middles from it.
Vec3 cube_middle(Cell first, int side, float voxel);
float cube_reach(int side, float voxel);

inline constexpr int kPartSide = 4;  ///< blocks are processed in eight parts, each with the items near it

enum class Filling {
  outside,  ///< no voxel is within the band
  inside,   ///< all lie deeper than the band
  crossed   ///< the band crosses it
};

/// The distance of each voxel of a block, z fastest, clamped to -band..band.
Filling fill_block(const BranchVolume& boughs, const Blocks& blocks, const FoundBlock& found,
                   std::span<float, kBlockVoxels> distance);

/// Estimated number of blocks that gather_blocks would make, using little memory for any number.
double count_blocks(const BranchVolume& boughs, double voxel, double band_voxels);

}  // namespace frond
