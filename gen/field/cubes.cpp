#include "field/cubes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr std::array<Cell, 6> kSteps{{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

/// Which voxels of a block are in the body.
struct Mask {
  std::uint64_t key;
  std::array<std::uint64_t, 8> bits{};
};

std::size_t index_in(Cell cell) {
  return static_cast<std::size_t>((cell.i & 7) << 6 | (cell.j & 7) << 3 | (cell.k & 7));
}

Cell cell_of(std::uint64_t key, std::size_t index) {
  Cell first = block_origin(key);
  auto at = static_cast<std::int32_t>(index);
  return {first.i + (at >> 6), first.j + (at >> 3 & 7), first.k + (at & 7)};
}

Cell plus(Cell a, Cell b) { return {a.i + b.i, a.j + b.j, a.k + b.k}; }

/// Calls visit(cell) for each cell that a line passes, face to face (Amanatides and Woo 1987).
template <class Visit>
void walk(Vec3 from, Vec3 to, float side, const Visit& visit) {
  Cell cell = voxel_at(from, side), end = voxel_at(to, side);
  std::array<std::int32_t, 3> at{cell.i, cell.j, cell.k}, last{end.i, end.j, end.k}, step{};
  std::array<double, 3> next{}, width{};
  for (int a = 0; a < 3; ++a) {
    auto axis = static_cast<std::size_t>(a);
    double way = to[a] - from[a];
    step[axis] = last[axis] > at[axis] ? 1 : -1;
    width[axis] = way != 0 ? side / std::abs(way) : 0;
    double wall = (at[axis] + 0.5 * step[axis]) * side;
    next[axis] = way != 0 ? (wall - from[a]) / way : 0;
  }
  visit(cell);
  // Each axis is stepped as often as its cells differ, whatever rounding says of where the walls are.
  for (;;) {
    std::size_t best = 3;
    for (std::size_t a = 0; a < 3; ++a)
      if (at[a] != last[a] && (best == 3 || next[a] < next[best])) best = a;
    if (best == 3) return;
    at[best] += step[best];
    next[best] += width[best];
    visit(Cell{at[0], at[1], at[2]});
  }
}

/// All cells of the body, as masks in the order of their keys.
std::vector<Mask> occupied(const Boughs& limbs, const Blocks& blocks) {
  std::vector<Mask> masks;
  for (const BlockList& list : blocks.lists) {
    std::size_t start = masks.size();
    masks.resize(start + list.blocks.size());
    parallel_for(list.blocks.size(), [&](std::size_t b) {
      Mask& mask = masks[start + b];
      mask.key = list.blocks[b].key;
      std::array<float, kBlockVoxels> distance;
      Filling filling = fill_block(limbs, blocks, {&list, &list.blocks[b]}, distance);
      for (std::size_t i = 0; i < kBlockVoxels; ++i)
        if (filling == Filling::inside || distance[i] < 0) mask.bits[i >> 6] |= std::uint64_t{1} << (i & 63);
    });
  }
  for (const Cone& cone : limbs.cones)
    walk(cone.from, cone.to(), blocks.voxel, [&](Cell cell) {
      std::size_t i = index_in(cell);
      std::uint64_t key = block_key(cell);
      if (masks.empty() || masks.back().key != key) masks.push_back({key, {}});
      masks.back().bits[i >> 6] |= std::uint64_t{1} << (i & 63);
    });
  std::stable_sort(masks.begin(), masks.end(), [](const Mask& a, const Mask& b) { return a.key < b.key; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < masks.size(); ++i) {
    if (kept > 0 && masks[kept - 1].key == masks[i].key)
      for (std::size_t w = 0; w < 8; ++w) masks[kept - 1].bits[w] |= masks[i].bits[w];
    else
      masks[kept++] = masks[i];
  }
  masks.resize(kept);
  return masks;
}

bool holds(const std::vector<Mask>& masks, const Mask& here, Cell cell) {
  std::uint64_t key = block_key(cell);
  std::size_t i = index_in(cell);
  const Mask* mask = &here;
  if (key != here.key) {
    auto at = std::lower_bound(masks.begin(), masks.end(), key,
                               [](const Mask& m, std::uint64_t k) { return m.key < k; });
    if (at == masks.end() || at->key != key) return false;
    mask = &*at;
  }
  return mask->bits[i >> 6] >> (i & 63) & 1;
}

}  // namespace

Result<Cubes> cubes_of(const Boughs& limbs, const VolumeOptions& options) {
  if (Errors errors = refuse_volume(limbs, options); !errors.empty()) return errors;
  auto side = static_cast<float>(options.voxel);
  Blocks blocks = gather_blocks(limbs, side, side);
  std::vector<Mask> masks = occupied(limbs, blocks);
  Cubes cubes{side, {}, {}, {}};
  Nearby near;
  for (const Mask& mask : masks) {
    FoundBlock found = find_block(blocks, block_origin(mask.key));
    near = {};
    if (found.block) near_block(limbs, blocks, found, near);
    for (std::size_t i = 0; i < kBlockVoxels; ++i) {
      if (!(mask.bits[i >> 6] >> (i & 63) & 1)) continue;
      Cell cell = cell_of(mask.key, i);
      std::uint8_t shown = 0;
      for (std::size_t f = 0; f < kSteps.size(); ++f)
        if (!holds(masks, mask, plus(cell, kSteps[f]))) shown |= static_cast<std::uint8_t>(1u << f);
      if (shown == 0) continue;
      FieldSample sample = sample_limbs(limbs, near, voxel_middle(cell, side));
      cubes.cell.push_back(cell);
      cubes.shown.push_back(shown);
      cubes.node.push_back(sample.cone < 0 ? 0 : limbs.cones[static_cast<std::size_t>(sample.cone)].node);
    }
  }
  return cubes;
}

Surface cubes_surface(const Cubes& cubes, std::vector<std::uint32_t>& cube) {
  Surface surface;
  cube.clear();
  for (std::size_t c = 0; c < cubes.size(); ++c) {
    Vec3 middle = voxel_middle(cubes.cell[c], cubes.side);
    for (std::size_t f = 0; f < kSteps.size(); ++f) {
      if (!(cubes.shown[c] >> f & 1)) continue;
      Cell step = kSteps[f];
      Vec3 out(static_cast<float>(step.i), static_cast<float>(step.j), static_cast<float>(step.k));
      Vec3 up = step.j != 0 ? Vec3(0, 0, 1) : Vec3(0, 1, 0), right = glm::cross(up, out);
      auto first = static_cast<std::uint32_t>(surface.position.size());
      for (int corner = 0; corner < 4; ++corner) {
        float x = corner == 1 || corner == 2 ? 1.0f : -1.0f, y = corner >= 2 ? 1.0f : -1.0f;
        surface.position.push_back(middle + 0.5f * cubes.side * (out + x * right + y * up));
        surface.normal.push_back(out);
      }
      surface.triangle.push_back({first, first + 1, first + 2});
      surface.triangle.push_back({first, first + 2, first + 3});
      cube.push_back(static_cast<std::uint32_t>(c));
    }
  }
  return surface;
}

}  // namespace frond
