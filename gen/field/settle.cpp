#include "field/settle.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr std::size_t kPartVertices = 8000;
constexpr int kNewtonSteps = 2;
constexpr float kEnough = 0.01f;          // voxels from the surface
constexpr float kMost = 0.6f;             // voxels that a vertex is moved at most
constexpr float kMargin = kMost + 0.87f;  // and from the middle of its own voxel

/// A vertex and where it is: the block, of that the part, and of that the eighth.
struct Placed {
  std::uint64_t block;
  std::uint32_t part, eighth, vertex;
};

/// Which of the eight halves in each direction a voxel is in, where those are `bit` wide.
std::uint32_t octant(Cell cell, int bit) {
  auto half = [&](std::int32_t x) { return static_cast<std::uint32_t>(x >> bit & 1); };
  return half(cell.i) << 2 | half(cell.j) << 1 | half(cell.k);
}

/// The first voxel of that.
Cell octant_origin(Cell first, std::uint32_t octant, int side) {
  first.i += static_cast<int>(octant >> 2 & 1) * side;
  first.j += static_cast<int>(octant >> 1 & 1) * side;
  first.k += static_cast<int>(octant & 1) * side;
  return first;
}

/// Moves one vertex along the slope of the distance until it is 0 (Newton's way).
void settle_vertex(const Boughs& boughs, const Nearby& near, float voxel, FusedMesh& mesh, std::uint32_t v) {
  assert(v < mesh.surface.position.size() && voxel > 0);
  Vec3 start = mesh.surface.position[v], at = start;
  FieldSample sample = sample_boughs(boughs, near, at);
  assert(sample.cone >= 0 && sample.cone < static_cast<std::int32_t>(boughs.cones.size()));
  float most = kMost * voxel;
  for (int step = 0; step < kNewtonSteps && std::abs(sample.distance) > kEnough * voxel; ++step) {
    Vec3 shift = at - sample.normal * sample.distance - start;
    float length = glm::length(shift);
    at = start + (length > most ? shift * (most / length) : shift);
    sample = sample_boughs(boughs, near, at);
  }
  mesh.surface.position[v] = at;
  mesh.surface.normal[v] = sample.normal;
  mesh.node[v] = boughs.cones[static_cast<std::size_t>(sample.cone)].node;
}

/// Settles the vertices of a range; those in one place share what is near it.
class Settler {
 public:
  Settler(const Boughs& boughs, const Blocks& blocks, FusedMesh& mesh)
      : boughs_(boughs), blocks_(blocks), mesh_(mesh) {}

  void settle(std::size_t from, std::size_t to) {
    assert(from <= to && to <= mesh_.surface.position.size());
    std::vector<Placed> own;
    for (std::size_t v = from; v < to; ++v) {
      Cell cell = voxel_at(mesh_.surface.position[v], blocks_.voxel);
      own.push_back({block_key(cell), octant(cell, 2), octant(cell, 1), static_cast<std::uint32_t>(v)});
    }
    std::sort(own.begin(), own.end(), [](const Placed& a, const Placed& b) {
      return std::tie(a.block, a.part, a.eighth, a.vertex) < std::tie(b.block, b.part, b.eighth, b.vertex);
    });
    for (std::size_t i = 0; i < own.size(); ++i) {
      look(own[i], i == 0 ? nullptr : &own[i - 1]);
      if (!near_.cones.empty()) settle_vertex(boughs_, near_, blocks_.voxel, mesh_, own[i].vertex);
    }
  }

 private:
  /// Finds what is near a vertex, unless it is where the last one was.
  void look(const Placed& at, const Placed* last) {
    bool block = !last || at.block != last->block, part = block || at.part != last->part;
    if (block) {
      FoundBlock found = find_block(blocks_, block_origin(at.block));
      listed_ = {};
      if (found.block) near_block(boughs_, blocks_, found, listed_);
    }
    Cell first = octant_origin(block_origin(at.block), at.part, kPartSide);
    if (part) choose(listed_, first, kPartSide, part_);
    if (part || at.eighth != last->eighth)
      choose(part_, octant_origin(first, at.eighth, kPartSide / 2), kPartSide / 2, near_);
  }

  void choose(const Nearby& from, Cell first, int side, Nearby& to) const {
    float voxel = blocks_.voxel;
    choose_near(boughs_, from, cube_middle(first, side, voxel), cube_reach(side, voxel) + kMargin * voxel,
                kMargin * voxel, to);
  }

  const Boughs& boughs_;
  const Blocks& blocks_;
  FusedMesh& mesh_;
  Nearby listed_, part_, near_;
};

}  // namespace

void settle(const Boughs& boughs, const Blocks& blocks, FusedMesh& mesh) {
  std::size_t count = mesh.surface.position.size(), parts = count / kPartVertices + 1;
  mesh.surface.normal.assign(count, Vec3(0, 1, 0));
  mesh.node.assign(count, 0);
  parallel_for(parts, [&](std::size_t p) {
    Settler(boughs, blocks, mesh).settle(count * p / parts, count * (p + 1) / parts);
  });
}

}  // namespace frond
