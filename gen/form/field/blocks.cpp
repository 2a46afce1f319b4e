#include "field/blocks.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/seed.h"

namespace frond {

namespace {

constexpr std::int32_t kMiddle = 1 << 20;  // keys hold places of blocks as numbers of 21 bits
constexpr std::uint32_t kFork = 1u << 31;  // marks forks among cones
constexpr std::size_t kPartCones = 2000;   // worked on by one thread at a time
constexpr double kMostLooks = 3e7;         // at blocks when they are counted
constexpr std::uint64_t kCounted = 16;     // one block in so many is counted

struct Near {
  std::uint64_t key;
  std::uint32_t item;

  auto operator<=>(const Near&) const = default;
};

std::int32_t block_of(float place, float side) { return static_cast<std::int32_t>(std::floor(place / side)); }

std::size_t list_of(std::uint64_t key) { return Seed::mix(key) >> 58; }

/// A box in blocks.
struct BlockBox {
  std::int32_t low[3], high[3];
  double count() const {
    double product = 1;
    for (int a = 0; a < 3; ++a) product *= high[a] - low[a] + 1.0;
    return product;
  }
};

BlockBox box_of(const RoundCone& cone, float margin, float voxel) {
  BlockBox box;
  Vec3 to = cone.to();
  float side = voxel * kBlockSide, end = cone.end_radius();
  for (int a = 0; a < 3; ++a) {
    float low = std::min(cone.from[a] - cone.radius, to[a] - end) - margin;
    float high = std::max(cone.from[a] + cone.radius, to[a] + end) + margin;
    box.low[a] = block_of(low, side), box.high[a] = block_of(high, side);
  }
  return box;
}

/// Calls visit(key) for each block that comes nearer to a cone than `band`.
template <class Visit>
void visit_near(const RoundCone& cone, float voxel, float band, const Visit& visit) {
  // A voxel more: places between the voxels are asked for, too.
  float margin = band + cube_reach(kBlockSide, voxel) + voxel;
  BlockBox box = box_of(cone, band + voxel, voxel);
  for (std::int32_t i = box.low[0]; i <= box.high[0]; ++i)
    for (std::int32_t j = box.low[1]; j <= box.high[1]; ++j)
      for (std::int32_t k = box.low[2]; k <= box.high[2]; ++k) {
        Cell first{i * kBlockSide, j * kBlockSide, k * kBlockSide};
        if (distance(cone, cube_middle(first, kBlockSide, voxel)) <= margin) visit(block_key(first));
      }
}

/// Notes a fork in the blocks in which it makes a difference.
void visit_fork(const BranchVolume& boughs, std::uint32_t f, float voxel, float band,
                std::vector<std::uint64_t>& keys, const auto& visit) {
  const Forks& forks = boughs.forks;
  const Forks::Fork& fork = forks.forks[f];
  float reach = fillet_reach(forks, f), half = cube_reach(kBlockSide, voxel) + voxel;
  keys.clear();
  for (std::uint32_t a = fork.first; a < fork.last; ++a)
    for (std::uint32_t m = forks.arms[a].first; m < forks.arms[a].last; ++m)
      visit_near(boughs.cones[forks.member[m]], voxel, band + reach,
                 [&](std::uint64_t key) { keys.push_back(key); });
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  for (std::uint64_t key : keys)
    if (choose_fork(boughs, forks, f, cube_middle(block_origin(key), kBlockSide, voxel), half, band, nullptr))
      visit(key);
}

/// One list of blocks from what all parts found for it.
BlockList list_from(std::vector<Near>& found) {
  std::ranges::sort(found);
  BlockList list;
  list.item.reserve(found.size());
  for (const Near& near : found) {
    auto at = static_cast<std::uint32_t>(list.item.size());
    if (list.blocks.empty() || list.blocks.back().key != near.key)
      list.blocks.push_back({near.key, at, at, at});
    VoxelBlock& block = list.blocks.back();
    list.item.push_back(near.item & ~kFork);
    block.last = at + 1;
    if (!(near.item & kFork)) block.forks = at + 1;
  }
  return list;
}

}  // namespace

Vec3 cube_middle(Cell first, int side, float voxel) {
  return voxel_middle(first, voxel) + Vec3(0.5f * voxel * static_cast<float>(side - 1));
}

float cube_reach(int side, float voxel) {
  return 0.5f * std::sqrt(3.0f) * voxel * static_cast<float>(side - 1);
}

std::size_t Blocks::size() const {
  std::size_t sum = 0;
  for (const BlockList& list : lists) sum += list.blocks.size();
  return sum;
}

std::uint64_t block_key(Cell voxel) {
  auto part = [](std::int32_t at) { return static_cast<std::uint64_t>((at >> 3) + kMiddle); };
  return part(voxel.i) << 42 | part(voxel.j) << 21 | part(voxel.k);
}

Cell block_origin(std::uint64_t key) {
  auto part = [](std::uint64_t bits) {
    return (static_cast<std::int32_t>(bits & (2 * kMiddle - 1)) - kMiddle) * kBlockSide;
  };
  return {part(key >> 42), part(key >> 21), part(key)};
}

Vec3 voxel_middle(Cell voxel, float size) { return Vec3(voxel.i, voxel.j, voxel.k) * size; }

Cell voxel_at(Vec3 place, float size) {
  auto near = [&](float x) { return static_cast<std::int32_t>(std::floor(x / size + 0.5f)); };
  return {near(place.x), near(place.y), near(place.z)};
}

bool fits_grid(const BranchVolume& boughs, float voxel) {
  float most = voxel * kBlockSide * static_cast<float>(kMiddle - 16);
  return std::all_of(boughs.cones.begin(), boughs.cones.end(), [&](const RoundCone& cone) {
    Vec3 to = cone.to();
    float reach = std::max(cone.radius, cone.end_radius());
    for (int a = 0; a < 3; ++a)
      if (std::max(std::abs(cone.from[a]), std::abs(to[a])) + reach > most) return false;
    return true;
  });
}

Blocks gather_blocks(const BranchVolume& boughs, float voxel, float band) {
  Blocks blocks{voxel, band, {}};
  constexpr std::size_t kLists = std::tuple_size_v<decltype(blocks.lists)>;
  std::size_t cones = boughs.cones.size(), parts = (cones + boughs.forks.size()) / kPartCones + 1;
  std::vector<std::array<std::vector<Near>, kLists>> found(parts);
  parallel_for(parts, [&](std::size_t p) {
    auto& own = found[p];
    for (std::size_t c = cones * p / parts; c < cones * (p + 1) / parts; ++c)
      visit_near(boughs.cones[c], voxel, band, [&](std::uint64_t key) {
        own[list_of(key)].push_back({key, static_cast<std::uint32_t>(c)});
      });
    std::vector<std::uint64_t> keys;
    std::size_t forks = boughs.forks.size();
    for (std::size_t f = forks * p / parts; f < forks * (p + 1) / parts; ++f)
      visit_fork(boughs, static_cast<std::uint32_t>(f), voxel, band, keys, [&](std::uint64_t key) {
        own[list_of(key)].push_back({key, static_cast<std::uint32_t>(f) | kFork});
      });
  });
  parallel_for(kLists, [&](std::size_t l) {
    std::vector<Near> all;
    for (auto& part : found) {
      all.insert(all.end(), part[l].begin(), part[l].end());
      part[l] = {};
    }
    blocks.lists[l] = list_from(all);
  });
  return blocks;
}

FoundBlock find_block(const Blocks& blocks, Cell voxel) {
  std::uint64_t key = block_key(voxel);
  const BlockList& list = blocks.lists[list_of(key)];
  auto at = std::ranges::lower_bound(list.blocks, key, {}, &VoxelBlock::key);
  if (at == list.blocks.end() || at->key != key) return {};
  return {&list, &*at};
}

void near_block(const BranchVolume& boughs, const Blocks& blocks, const FoundBlock& found, Nearby& near) {
  std::span<const std::uint32_t> items(found.list->item);
  const VoxelBlock& block = *found.block;
  auto cones = items.subspan(block.first, block.forks - block.first);
  near.cones.assign(cones.begin(), cones.end());
  near.forks.clear();
  float half = cube_reach(kBlockSide, blocks.voxel) + blocks.voxel;
  Vec3 middle = cube_middle(block_origin(block.key), kBlockSide, blocks.voxel);
  for (std::uint32_t f : items.subspan(block.forks, block.last - block.forks))
    choose_fork(boughs, boughs.forks, f, middle, half, blocks.band, &near.forks);
}

double count_blocks(const BranchVolume& boughs, double voxel, double band_voxels) {
  // Where there are too many to be looked at they are counted on a coarser grid; of a surface there are four
  // times as many on one twice as fine.
  double looks = 0, factor = 1;
  for (;; voxel *= 2, factor *= 4) {
    looks = 0;
    double band = band_voxels * voxel;
    for (const RoundCone& cone : boughs.cones)
      looks += box_of(cone, static_cast<float>(band), static_cast<float>(voxel)).count();
    if (looks <= std::max(kMostLooks, 64.0 * static_cast<double>(boughs.cones.size()))) break;
  }
  auto size = static_cast<float>(voxel);
  std::vector<std::uint64_t> keys;
  for (const RoundCone& cone : boughs.cones)
    visit_near(cone, size, static_cast<float>(band_voxels) * size, [&](std::uint64_t key) {
      if (Seed::mix(key) % kCounted == 0) keys.push_back(key);
    });
  std::sort(keys.begin(), keys.end());
  auto last = std::unique(keys.begin(), keys.end());
  return factor * static_cast<double>(kCounted) * static_cast<double>(last - keys.begin());
}

}  // namespace frond
