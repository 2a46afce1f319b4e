#include "creeping/spatial_hash.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/seed.h"

namespace frond {

namespace {

constexpr double kCell = 2;        // spacings: of 1.5 to 3, measured, the fastest
constexpr double kOwnTail = 2.2;   // spacings along itself in which a strand is not in its own way
constexpr double kFromRoot = 1.2;  // spacings along itself in which a branch's parent is not in its way

std::int32_t cell_of(double x, double size) {
  return static_cast<std::int32_t>(std::clamp(std::floor(x / size), -2e9, 2e9));
}

/// Where in its block a cell is.
std::int32_t within_block(std::int32_t x, std::int32_t y, std::int32_t z) {
  return ((x & 3) * 4 + (y & 3)) * 4 + (z & 3);
}

/// Which of eight places, an axis a row, are nearer than that: a bit each. Four at a time, in the vectors of
/// GCC and Clang: their loops over so few come out one by one.
std::uint32_t within(const std::array<std::array<float, 8>, 3>& places, Vec3 of, float reach2) {
  typedef float Four __attribute__((vector_size(16)));
  typedef std::int32_t Marks __attribute__((vector_size(16)));
  auto marked = [&](int first, Marks bits) {
    Four x, y, z;
    std::memcpy(&x, &places[0][first], sizeof x);
    std::memcpy(&y, &places[1][first], sizeof y);
    std::memcpy(&z, &places[2][first], sizeof z);
    x = of.x - x, y = of.y - y, z = of.z - z;
    return (x * x + y * y + z * z < reach2) & bits;
  };
  auto pairs = std::bit_cast<std::array<std::uint64_t, 2>>(marked(0, Marks{1, 2, 4, 8}) |
                                                           marked(4, Marks{16, 32, 64, 128}));
  std::uint64_t both = pairs[0] | pairs[1];
  return static_cast<std::uint32_t>(both | both >> 32);
}

/// The cells of a block that lie in a box, 0..3 each way, a bit each.
std::uint64_t cells_between(const std::int32_t low[3], const std::int32_t high[3]) {
  auto span = [](std::int32_t from, std::int32_t to) { return (2u << to) - (1u << from); };
  std::uint64_t row = span(low[2], high[2]), slice = 0, box = 0;
  for (std::int32_t y = low[1]; y <= high[1]; ++y) slice |= row << 4 * y;
  for (std::int32_t x = low[0]; x <= high[0]; ++x) box |= slice << 16 * x;
  return box;
}

}  // namespace

SpatialHash::SpatialHash(double spacing) : spacing_(spacing), size_(kCell * spacing), blocks_(1024) {}

/// Where a block is, or would be.
std::size_t SpatialHash::slot(std::int32_t x, std::int32_t y, std::int32_t z) const {
  auto word = [](std::int32_t v) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v)); };
  std::size_t mask = blocks_.size() - 1;
  std::size_t i = Seed::mix((word(x) << 32 | word(y)) ^ word(z) * 0x9e3779b97f4a7c15ull) & mask;
  while (blocks_[i].cells >= 0 && (blocks_[i].x != x || blocks_[i].y != y || blocks_[i].z != z))
    i = (i + 1) & mask;
  return i;
}

void SpatialHash::grow() {
  std::vector<Block> old(blocks_.size() * 2);
  old.swap(blocks_);
  for (const Block& b : old)
    if (b.cells >= 0) blocks_[slot(b.x, b.y, b.z)] = b;
}

void SpatialHash::add(const Member& member) {
  if (2 * used_ >= blocks_.size()) grow();
  std::int32_t x = cell_of(member.place.x, size_), y = cell_of(member.place.y, size_),
               z = cell_of(member.place.z, size_);
  Block& block = blocks_[slot(x >> 2, y >> 2, z >> 2)];
  if (block.cells < 0) {
    block = {x >> 2, y >> 2, z >> 2, static_cast<std::int32_t>(cells_.size())};
    cells_.resize(cells_.size() + 64, -1);
    ++used_;
  }
  std::int32_t cell = within_block(x, y, z);
  block.taken |= std::uint64_t{1} << cell;
  std::int32_t& last = cells_[block.cells + cell];
  if (last < 0 || chunks_[last].count == Chunk::kMost) {
    Chunk& chunk = chunks_.emplace_back();
    chunk.place[0].fill(std::numeric_limits<float>::infinity());
    chunk.before = last;
    last = static_cast<std::int32_t>(chunks_.size()) - 1;
  }
  Chunk& chunk = chunks_[last];
  std::int32_t i = chunk.count++;
  for (int axis = 0; axis < 3; ++axis) chunk.place[axis][i] = member.place[axis];
  chunk.rest[i] = {member.strand, member.since, member.normal};
}

void SpatialHash::gather(const DVec3& place, const DVec3& normal, const Own& own, double reach,
                         std::vector<DVec3>& near) const {
  near.clear();
  // In single precision, as the members are.
  Vec3 here(place), side(normal);
  float reach2 = static_cast<float>(reach * reach), recent = static_cast<float>(kOwnTail * spacing_),
        since = static_cast<float>(own.since);
  bool young = own.since < kFromRoot * spacing_;
  auto consider = [&](const Chunk& chunk) {
    for (std::uint32_t hits = within(chunk.place, here, reach2); hits != 0; hits &= hits - 1) {
      int i = std::countr_zero(hits);
      const Chunk::Rest& rest = chunk.rest[i];
      if (rest.strand == own.strand && since - rest.since < recent) continue;
      if (young && rest.strand == own.parent) continue;
      // What creeps on the other side of a thin wall is not in the way.
      if (glm::dot(rest.normal, side) < 0) continue;
      near.emplace_back(chunk.place[0][i], chunk.place[1][i], chunk.place[2][i]);
    }
  };
  std::int32_t low[3], high[3];
  for (int i = 0; i < 3; ++i) {
    low[i] = cell_of(place[i] - reach, size_);
    high[i] = cell_of(place[i] + reach, size_);
  }
  auto look_into = [&](const Block& block) {
    std::int32_t corner[3] = {block.x * 4, block.y * 4, block.z * 4}, from[3], to[3];
    for (int i = 0; i < 3; ++i) {
      from[i] = std::max(low[i] - corner[i], 0);
      to[i] = std::min(high[i] - corner[i], 3);
    }
    for (std::uint64_t cells = block.taken & cells_between(from, to); cells != 0; cells &= cells - 1)
      for (std::int32_t c = cells_[block.cells + std::countr_zero(cells)]; c >= 0; c = chunks_[c].before)
        consider(chunks_[c]);
  };
  for (std::int32_t x = low[0] >> 2; x <= high[0] >> 2; ++x)
    for (std::int32_t y = low[1] >> 2; y <= high[1] >> 2; ++y)
      for (std::int32_t z = low[2] >> 2; z <= high[2] >> 2; ++z)
        if (const Block& block = blocks_[slot(x, y, z)]; block.cells >= 0) look_into(block);
}

SpatialHash::View SpatialHash::view(std::span<const DVec3> near, const DVec3& place) const {
  View view{spacing_, DVec3(0)};
  for (const DVec3& other : near) {
    DVec3 offset = place - other;
    double d2 = glm::dot(offset, offset);
    if (d2 >= spacing_ * spacing_) continue;
    double d = std::sqrt(d2);
    view.nearest = std::min(view.nearest, d);
    view.away += offset * ((1 - d / spacing_) / std::max(d, 1e-3 * spacing_));
  }
  return view;
}

double SpatialHash::nearest(std::span<const DVec3> near, const DVec3& place) const {
  double least = spacing_ * spacing_;
  for (const DVec3& other : near) {
    DVec3 offset = place - other;
    least = std::min(least, glm::dot(offset, offset));
  }
  return least < spacing_ * spacing_ ? std::sqrt(least) : spacing_;
}

}  // namespace frond
