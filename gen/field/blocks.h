#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "field/boughs.h"

namespace frond {

inline constexpr int kBlockSide = 8;
inline constexpr int kBlockVoxels = kBlockSide * kBlockSide * kBlockSide;

/// A place on the grid of voxels: voxel (i, j, k) has its middle at that many voxels from the world's origin,
/// so that the grid is the same in each frame.
struct Cell {
  std::int32_t i = 0, j = 0, k = 0;
  bool operator==(const Cell&) const = default;
};

/// A cube of 8 x 8 x 8 voxels and what is near it.
struct VoxelBlock {
  std::uint64_t key;                 ///< of its place
  std::uint32_t first, forks, last;  ///< in BlockList::item: its cones, and from `forks` on its forks
};

struct BlockList {
  std::vector<VoxelBlock> blocks;  ///< by key
  std::vector<std::uint32_t> item;
};

/// All blocks within `band` of the surface, or inside near it, in a number of lists that does not depend on
/// the number of threads.
struct Blocks {
  float voxel = 0.01f, band = 0.03f;  ///< metres
  std::array<BlockList, 64> lists;

  std::size_t size() const;
};

/// The first voxel of the block with this key, and the key of the block that a voxel is in.
Cell block_origin(std::uint64_t key);
std::uint64_t block_key(Cell voxel);

/// The middle of a voxel, metres; and the voxel that a place is in.
Vec3 voxel_middle(Cell voxel, float size);
Cell voxel_at(Vec3 place, float size);

/// Whether all places of the boughs are on a grid of such voxels: within 8 million voxels of the origin.
bool fits_grid(const Boughs& boughs, float voxel);

/// Sorts cones and forks into the blocks that they are near.
Blocks gather_blocks(const Boughs& boughs, float voxel, float band);

/// The block that a voxel is in and its list, or nulls where there is none.
struct FoundBlock {
  const BlockList* list = nullptr;
  const VoxelBlock* block = nullptr;
};
FoundBlock find_block(const Blocks& blocks, Cell voxel);

/// What a block lists, its forks held to what counts in it and within a voxel round it.
void near_block(const Boughs& boughs, const Blocks& blocks, const FoundBlock& found, Nearby& near);

/// The middle of a cube of `side` voxels, and how far from it their middles are at most.
Vec3 cube_middle(Cell first, int side, float voxel);
float cube_reach(int side, float voxel);

inline constexpr int kPartSide = 4;  ///< blocks are worked on in eight parts, each with what is near it

enum class Filling {
  outside,  ///< no voxel is within the band
  inside,   ///< all lie deeper than the band
  crossed   ///< by the band
};

/// The distance of each voxel of a block, z fastest, held to -band..band.
Filling fill_block(const Boughs& boughs, const Blocks& blocks, const FoundBlock& found,
                   std::span<float, kBlockVoxels> distance);

/// About how many blocks gather_blocks would make, in little memory and however many they are.
double count_blocks(const Boughs& boughs, double voxel, double band_voxels);

}  // namespace frond
