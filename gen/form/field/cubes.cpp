#include "field/cubes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "field/cells.h"
#include "field/whole.h"

namespace frond {

namespace {

constexpr std::array<Cell, 6> kFaces{{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

Cell plus(Cell a, Cell b) { return {a.i + b.i, a.j + b.j, a.k + b.k}; }

/// Calls visit(cell) for each cell that a line passes, face to face (Amanatides and Woo 1987).
template <class Visit>
void walk(Vec3 from, Vec3 to, float side, const Visit& visit) {
  Cell cell = voxel_at(from, side), end = voxel_at(to, side);
  std::array<std::int32_t, 3> at{cell.i, cell.j, cell.k}, last{end.i, end.j, end.k}, step{};
  std::array<double, 3> next{}, width{};
  for (int a = 0; a < 3; ++a) {
    auto axis = static_cast<std::size_t>(a);
    double offset = to[a] - from[a];
    step[axis] = last[axis] > at[axis] ? 1 : -1;
    width[axis] = offset != 0 ? side / std::abs(offset) : 0;
    double wall = (at[axis] + 0.5 * step[axis]) * side;
    next[axis] = offset != 0 ? (wall - from[a]) / offset : 0;
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

/// All cells of the body.
CellSet occupied(const BranchVolume& boughs, const Blocks& blocks) {
  CellSet cells;
  for (const BlockList& list : blocks.lists) {
    std::vector<std::array<bool, kBlockVoxels>> within(list.blocks.size());
    parallel_for(list.blocks.size(), [&](std::size_t b) {
      std::array<float, kBlockVoxels> distance;
      Filling filling = fill_block(boughs, blocks, {&list, &list.blocks[b]}, distance);
      for (std::size_t i = 0; i < kBlockVoxels; ++i)
        within[b][i] = filling == Filling::inside || distance[i] < 0;
    });
    for (std::size_t b = 0; b < within.size(); ++b) {
      Cell first = block_origin(list.blocks[b].key);
      for (std::int32_t i = 0; i < kBlockVoxels; ++i)
        if (within[b][i]) cells.add({first.i + (i >> 6), first.j + (i >> 3 & 7), first.k + (i & 7)});
    }
  }
  for (const RoundCone& cone : boughs.cones)
    walk(cone.from, cone.to(), blocks.voxel, [&](Cell cell) { cells.add(cell); });
  mend_contacts(cells);
  return cells;
}

/// The corners of a face, counter-clockwise seen from outside. Corner (i, j, k) of the grid is the lowest of
/// cell (i, j, k).
std::array<Cell, 4> face_corners(Cell cell, std::size_t face) {
  Cell out = kFaces[face];
  Cell up = out.j != 0 ? Cell{0, 0, 1} : Cell{0, 1, 0};
  Cell right{up.j * out.k - up.k * out.j, up.k * out.i - up.i * out.k, up.i * out.j - up.j * out.i};
  std::array<Cell, 4> corners;
  for (int c = 0; c < 4; ++c) {
    int x = c == 1 || c == 2 ? 1 : -1, y = c >= 2 ? 1 : -1;
    corners[c] = {cell.i + (1 + out.i + x * right.i + y * up.i) / 2,
                  cell.j + (1 + out.j + x * right.j + y * up.j) / 2,
                  cell.k + (1 + out.k + x * right.k + y * up.k) / 2};
  }
  return corners;
}

template <class Visit>
void visit_faces(const Cubes& cubes, const Visit& visit) {
  for (std::size_t c = 0; c < cubes.size(); ++c)
    for (std::size_t f = 0; f < kFaces.size(); ++f)
      if (cubes.shown[c] >> f & 1) visit(c, f);
}

/// The faces that show as a mesh whose triangles share their corners, in cells.
Surface joined_faces(const Cubes& cubes, std::vector<std::int32_t>& node) {
  std::vector<Cell> all;
  visit_faces(cubes, [&](std::size_t c, std::size_t f) {
    for (Cell corner : face_corners(cubes.cell[c], f)) all.push_back(corner);
  });
  std::vector<Cell> corners = all;
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  Surface s;
  for (auto [i, j, k] : corners) s.position.emplace_back(i, j, k);
  node.assign(corners.size(), 0);
  std::size_t next = 0;
  visit_faces(cubes, [&](std::size_t c, std::size_t) {
    std::array<std::uint32_t, 4> v{};
    for (std::uint32_t& corner : v) {
      auto at = std::lower_bound(corners.begin(), corners.end(), all[next++]);
      corner = static_cast<std::uint32_t>(at - corners.begin());
      node[corner] = cubes.node[c];
    }
    add_quad(s, v[0], v[1], v[2], v[3]);
  });
  return s;
}

/// Hides the walls of voids, and cubes that lie apart.
void keep_outsides(Cubes& cubes, const BranchVolume& boughs) {
  std::vector<std::int32_t> node;
  Surface faces = joined_faces(cubes, node);
  std::vector<bool> outside = outsides(faces, node, boughs);
  std::size_t next = 0, kept = 0;
  std::vector<std::uint8_t> shown(cubes.size());
  visit_faces(cubes, [&](std::size_t c, std::size_t f) {
    if (outside[2 * next++]) shown[c] |= static_cast<std::uint8_t>(1u << f);
  });
  for (std::size_t c = 0; c < cubes.size(); ++c) {
    if (shown[c] == 0) continue;
    cubes.cell[kept] = cubes.cell[c], cubes.node[kept] = cubes.node[c], cubes.shown[kept++] = shown[c];
  }
  cubes.cell.resize(kept), cubes.node.resize(kept), cubes.shown.resize(kept);
}

}  // namespace

Result<Cubes> cubes_of(const BranchVolume& boughs, const VolumeOptions& options) {
  if (Errors errors = refuse_volume(boughs, options); !errors.empty()) return errors;
  auto side = static_cast<float>(options.voxel);
  Blocks blocks = gather_blocks(boughs, side, side);
  CellSet cells = occupied(boughs, blocks);
  Cubes cubes{side, {}, {}, {}};
  Nearby near;
  std::uint64_t last = UINT64_MAX;
  cells.visit([&](Cell cell) {
    std::uint8_t shown = 0;
    for (std::size_t f = 0; f < kFaces.size(); ++f)
      if (!cells.holds(plus(cell, kFaces[f]))) shown |= static_cast<std::uint8_t>(1u << f);
    if (shown == 0) return;
    if (std::uint64_t key = block_key(cell); key != last) {
      FoundBlock found = find_block(blocks, cell);
      near = {};
      if (found.block) near_block(boughs, blocks, found, near);
      last = key;
    }
    FieldSample sample = sample_boughs(boughs, near, voxel_middle(cell, side));
    // A cube that was added far from all cones is of the one before it.
    std::int32_t before = cubes.node.empty() ? boughs.cones[0].node : cubes.node.back();
    cubes.cell.push_back(cell);
    cubes.shown.push_back(shown);
    cubes.node.push_back(sample.cone < 0 ? before : boughs.cones[sample.cone].node);
  });
  keep_outsides(cubes, boughs);
  return cubes;
}

Surface cubes_surface(const Cubes& cubes, std::vector<std::uint32_t>& cube) {
  Surface surface;
  cube.clear();
  visit_faces(cubes, [&](std::size_t c, std::size_t f) {
    Vec3 out(kFaces[f].i, kFaces[f].j, kFaces[f].k);
    auto first = static_cast<std::uint32_t>(surface.position.size());
    for (Cell corner : face_corners(cubes.cell[c], f)) {
      // All faces that meet at a corner get the same numbers, or there would be gaps of the last digit.
      surface.position.push_back(voxel_middle(corner, cubes.side) - Vec3(0.5f * cubes.side));
      surface.normal.push_back(out);
    }
    add_quad(surface, first, first + 1, first + 2, first + 3);
    cube.push_back(static_cast<std::uint32_t>(c));
  });
  return surface;
}

}  // namespace frond
