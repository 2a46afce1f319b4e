#include "field/settle.h"

#include <algorithm>
#include <cassert>
#include <compare>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr std::size_t kPartVertices = 8000;
constexpr int kNewtonSteps = 2;
constexpr float kEnough = 0.01f;          // voxels from the surface
constexpr float kMost = 0.6f;             // voxels that a vertex is moved at most
constexpr float kMargin = kMost + 0.87f;  // and from the middle of its own voxel
constexpr float kShared =
    1;  // voxels by which a branch that carries a vertex may be farther than the nearest
static_assert(kShared <= 2 * kMost, "what is near a vertex is only found so far");

/// A vertex and where it is: the block, of that the part, and of that the eighth.
struct Placed {
  std::uint64_t block;
  std::uint32_t part, eighth, vertex;

  auto operator<=>(const Placed&) const = default;
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
void settle_vertex(const BranchVolume& boughs, const Nearby& near, float voxel, FusedMesh& mesh,
                   std::uint32_t v) {
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
  mesh.node[v] = boughs.cones[sample.cone].node;
}

/// The way that the branches near a vertex carry it, the nearest most; notes the node of that one. It changes
/// steadily from place to place, also between branches that only touch.
Vec3 carry_vertex(const BranchVolume& boughs, const Nearby& near, const Carriage& carriage, float voxel,
                  Vec3 at, std::int32_t& node) {
  const RoundCone* nearest = &boughs.cones[near.cones[0]];
  float least = distance(*nearest, at);
  for (std::uint32_t c : near.cones)
    if (float d = distance(boughs.cones[c], at); d < least) least = d, nearest = &boughs.cones[c];
  node = nearest->node;
  Vec3 sum(0);
  float weights = 0;
  for (std::uint32_t c : near.cones) {
    float share = 1 - (distance(boughs.cones[c], at) - least) / (kShared * voxel);
    if (share <= 0) continue;
    auto n = static_cast<std::size_t>(boughs.cones[c].node);
    sum += share * share * (carriage.posed[n] + carriage.turn[n] * (at - carriage.rest[n]) - at);
    weights += share * share;
  }
  return sum / weights;
}

/// Finds what is near the vertices of a range; those in one place share it.
class NearFinder {
 public:
  NearFinder(const BranchVolume& boughs, const Blocks& blocks, std::span<const Vec3> position)
      : boughs_(boughs), blocks_(blocks), position_(position) {}

  /// Calls visit(near, v) for each vertex that has a branch near it; it may move that vertex.
  template <class Visit>
  void look(std::size_t from, std::size_t to, const Visit& visit) {
    assert(from <= to && to <= position_.size());
    std::vector<Placed> own;
    for (std::size_t v = from; v < to; ++v) {
      Cell cell = voxel_at(position_[v], blocks_.voxel);
      own.push_back({block_key(cell), octant(cell, 2), octant(cell, 1), static_cast<std::uint32_t>(v)});
    }
    std::ranges::sort(own);
    for (std::size_t i = 0; i < own.size(); ++i) {
      go_to(own[i], i == 0 ? nullptr : &own[i - 1]);
      if (!near_.cones.empty()) visit(near_, own[i].vertex);
    }
  }

 private:
  /// Finds what is near a vertex, unless it is where the last one was.
  void go_to(const Placed& at, const Placed* last) {
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

  const BranchVolume& boughs_;
  const Blocks& blocks_;
  std::span<const Vec3> position_;
  Nearby listed_, part_, near_;
};

/// Calls visit(near, v) for all vertices of a mesh, on all threads.
template <class Visit>
void visit_vertices(const BranchVolume& boughs, const Blocks& blocks, const FusedMesh& mesh,
                    const Visit& visit) {
  std::size_t count = mesh.surface.position.size(), parts = count / kPartVertices + 1;
  parallel_for(parts, [&](std::size_t p) {
    NearFinder(boughs, blocks, mesh.surface.position).look(count * p / parts, count * (p + 1) / parts, visit);
  });
}

}  // namespace

void settle(const BranchVolume& boughs, const Blocks& blocks, FusedMesh& mesh) {
  mesh.surface.normal.assign(mesh.surface.position.size(), Vec3(0, 1, 0));
  mesh.node.assign(mesh.surface.position.size(), 0);
  visit_vertices(boughs, blocks, mesh, [&](const Nearby& near, std::uint32_t v) {
    settle_vertex(boughs, near, blocks.voxel, mesh, v);
  });
}

std::vector<Vec3> carried_by(const BranchVolume& boughs, const Blocks& blocks, const Carriage& carriage,
                             FusedMesh& mesh) {
  std::vector<Vec3> way(mesh.surface.position.size(), Vec3(0));
  mesh.node.assign(way.size(), 0);
  visit_vertices(boughs, blocks, mesh, [&](const Nearby& near, std::uint32_t v) {
    way[v] = carry_vertex(boughs, near, carriage, blocks.voxel, mesh.surface.position[v], mesh.node[v]);
  });
  return way;
}

}  // namespace frond
