#include "growth/crowd.h"

#include <algorithm>
#include <cmath>

#include "core/seed.h"

namespace frond {

namespace {

constexpr double kCell = 2;  // spacings: of 1.5 to 3, measured, the fastest

std::int32_t cell_of(double x, double size) {
  return static_cast<std::int32_t>(std::clamp(std::floor(x / size), -2e9, 2e9));
}

/// Where in its block a cell is.
std::int32_t within_block(std::int32_t x, std::int32_t y, std::int32_t z) {
  return ((x & 3) * 4 + (y & 3)) * 4 + (z & 3);
}

}  // namespace

Crowd::Crowd(double spacing) : spacing_(spacing), size_(kCell * spacing), blocks_(1024) {}

/// Where a block is, or would be.
std::size_t Crowd::slot(std::int32_t x, std::int32_t y, std::int32_t z) const {
  auto word = [](std::int32_t v) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v)); };
  std::size_t mask = blocks_.size() - 1;
  std::size_t i = Seed::mix((word(x) << 32 | word(y)) ^ word(z) * 0x9e3779b97f4a7c15ull) & mask;
  while (blocks_[i].cells >= 0 && (blocks_[i].x != x || blocks_[i].y != y || blocks_[i].z != z))
    i = (i + 1) & mask;
  return i;
}

void Crowd::grow() {
  std::vector<Block> old(blocks_.size() * 2);
  old.swap(blocks_);
  for (const Block& b : old)
    if (b.cells >= 0) blocks_[slot(b.x, b.y, b.z)] = b;
}

void Crowd::add(const Member& member) {
  if (2 * used_ >= blocks_.size()) grow();
  std::int32_t x = cell_of(member.place.x, size_), y = cell_of(member.place.y, size_),
               z = cell_of(member.place.z, size_);
  Block& block = blocks_[slot(x >> 2, y >> 2, z >> 2)];
  if (block.cells < 0) {
    block = {x >> 2, y >> 2, z >> 2, static_cast<std::int32_t>(cells_.size())};
    cells_.resize(cells_.size() + 64, -1);
    ++used_;
  }
  std::int32_t& last = cells_[block.cells + within_block(x, y, z)];
  if (last < 0 || chunks_[last].count == 7) {
    chunks_.emplace_back();
    chunks_.back().before = last;
    last = static_cast<std::int32_t>(chunks_.size()) - 1;
  }
  Chunk& chunk = chunks_[last];
  chunk.member[chunk.count++] = member;
}

void Crowd::gather(const DVec3& place, const DVec3& normal, const Own& own, double reach,
                   std::vector<DVec3>& near) const {
  near.clear();
  // In single precision, as the members are.
  Vec3 here(place), side(normal);
  float reach2 = static_cast<float>(reach * reach), recent = static_cast<float>(2.2 * spacing_),
        since = static_cast<float>(own.since);
  bool young = own.since < 1.2 * spacing_;
  auto consider = [&](const Member& other) {
    Vec3 way = here - other.place;
    if (glm::dot(way, way) >= reach2) return;
    if (other.strand == own.strand && since - other.since < recent) return;
    if (young && other.strand == own.parent) return;
    // What creeps on the other side of a thin wall is not in the way.
    if (glm::dot(other.normal, side) < 0) return;
    near.push_back(other.place);
  };
  std::int32_t low[3], high[3];
  for (int i = 0; i < 3; ++i) {
    low[i] = cell_of(place[i] - reach, size_);
    high[i] = cell_of(place[i] + reach, size_);
  }
  auto look_into = [&](const Block& block) {
    std::int32_t from[3] = {block.x * 4, block.y * 4, block.z * 4}, to[3];
    for (int i = 0; i < 3; ++i) to[i] = std::min(high[i], from[i] + 3), from[i] = std::max(low[i], from[i]);
    for (std::int32_t x = from[0]; x <= to[0]; ++x)
      for (std::int32_t y = from[1]; y <= to[1]; ++y)
        for (std::int32_t z = from[2]; z <= to[2]; ++z)
          for (std::int32_t c = cells_[block.cells + within_block(x, y, z)]; c >= 0; c = chunks_[c].before)
            for (std::int32_t m = 0; m < chunks_[c].count; ++m) consider(chunks_[c].member[m]);
  };
  for (std::int32_t x = low[0] >> 2; x <= high[0] >> 2; ++x)
    for (std::int32_t y = low[1] >> 2; y <= high[1] >> 2; ++y)
      for (std::int32_t z = low[2] >> 2; z <= high[2] >> 2; ++z)
        if (const Block& block = blocks_[slot(x, y, z)]; block.cells >= 0) look_into(block);
}

Crowd::View Crowd::view(std::span<const DVec3> near, const DVec3& place) const {
  View view{spacing_, DVec3(0)};
  for (const DVec3& other : near) {
    DVec3 way = place - other;
    double d2 = glm::dot(way, way);
    if (d2 >= spacing_ * spacing_) continue;
    double d = std::sqrt(d2);
    view.nearest = std::min(view.nearest, d);
    view.away += way * ((1 - d / spacing_) / std::max(d, 1e-3 * spacing_));
  }
  return view;
}

}  // namespace frond
