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

}  // namespace

Crowd::Crowd(double spacing) : spacing_(spacing), size_(kCell * spacing), cells_(1024) {}

/// Where a cell is, or would be.
std::size_t Crowd::slot(std::int32_t x, std::int32_t y, std::int32_t z) const {
  auto word = [](std::int32_t v) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v)); };
  std::size_t mask = cells_.size() - 1;
  std::size_t i = Seed::mix((word(x) << 32 | word(y)) ^ word(z) * 0x9e3779b97f4a7c15ull) & mask;
  while (cells_[i].last >= 0 && (cells_[i].x != x || cells_[i].y != y || cells_[i].z != z))
    i = (i + 1) & mask;
  return i;
}

void Crowd::grow() {
  std::vector<Cell> old(cells_.size() * 2);
  old.swap(cells_);
  for (const Cell& c : old)
    if (c.last >= 0) cells_[slot(c.x, c.y, c.z)] = c;
}

void Crowd::add(const Member& member) {
  if (2 * used_ >= cells_.size()) grow();
  std::int32_t x = cell_of(member.place.x, size_), y = cell_of(member.place.y, size_),
               z = cell_of(member.place.z, size_);
  Cell& cell = cells_[slot(x, y, z)];
  if (cell.last < 0) {
    cell = {x, y, z, -1};
    ++used_;
  }
  if (cell.last < 0 || chunks_[cell.last].count == 7) {
    chunks_.emplace_back();
    chunks_.back().before = cell.last;
    cell.last = static_cast<std::int32_t>(chunks_.size()) - 1;
  }
  Chunk& chunk = chunks_[cell.last];
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
  for (std::int32_t x = low[0]; x <= high[0]; ++x)
    for (std::int32_t y = low[1]; y <= high[1]; ++y)
      for (std::int32_t z = low[2]; z <= high[2]; ++z)
        for (std::int32_t c = cells_[slot(x, y, z)].last; c >= 0; c = chunks_[c].before)
          for (std::int32_t m = 0; m < chunks_[c].count; ++m) consider(chunks_[c].member[m]);
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
