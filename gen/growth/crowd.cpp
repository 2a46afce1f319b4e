#include "growth/crowd.h"

#include <algorithm>
#include <cmath>

#include "core/seed.h"

namespace frond {

namespace {

std::int32_t cell_of(double x, double size) {
  return static_cast<std::int32_t>(std::clamp(std::floor(x / size), -2e9, 2e9));
}

}  // namespace

Crowd::Crowd(double spacing) : spacing_(spacing), cells_(1024) {}

/// Where a cell is, or would be.
std::size_t Crowd::slot(std::int32_t x, std::int32_t y, std::int32_t z) const {
  auto word = [](std::int32_t v) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v)); };
  std::size_t mask = cells_.size() - 1;
  std::size_t i = Seed::mix(Seed::mix(word(x) << 32 | word(y)) ^ word(z)) & mask;
  while (cells_[i].first >= 0 && (cells_[i].x != x || cells_[i].y != y || cells_[i].z != z))
    i = (i + 1) & mask;
  return i;
}

void Crowd::grow() {
  std::vector<Cell> old(cells_.size() * 2);
  old.swap(cells_);
  for (const Cell& c : old)
    if (c.first >= 0) cells_[slot(c.x, c.y, c.z)] = c;
}

void Crowd::add(const Member& member) {
  if (2 * used_ >= cells_.size()) grow();
  std::int32_t x = cell_of(member.place.x, spacing_), y = cell_of(member.place.y, spacing_),
               z = cell_of(member.place.z, spacing_);
  Cell& cell = cells_[slot(x, y, z)];
  if (cell.first < 0) {
    cell = {x, y, z, -1};
    ++used_;
  }
  members_.push_back(member);
  members_.back().next = cell.first;
  cell.first = static_cast<std::int32_t>(members_.size()) - 1;
}

Crowd::View Crowd::look(const DVec3& place, const DVec3& normal, const Own& own) const {
  View view{spacing_, DVec3(0)};
  double reach2 = spacing_ * spacing_, recent = 2.2 * spacing_;
  bool young = own.since < 2 * spacing_;
  std::int32_t low[3], high[3];
  for (int i = 0; i < 3; ++i) {
    low[i] = cell_of(place[i] - spacing_, spacing_);
    high[i] = cell_of(place[i] + spacing_, spacing_);
  }
  for (std::int32_t x = low[0]; x <= high[0]; ++x)
    for (std::int32_t y = low[1]; y <= high[1]; ++y)
      for (std::int32_t z = low[2]; z <= high[2]; ++z) {
        for (std::int32_t m = cells_[slot(x, y, z)].first; m >= 0; m = members_[m].next) {
          const Member& other = members_[m];
          DVec3 way = place - DVec3(other.place);
          double d2 = glm::dot(way, way);
          if (d2 >= reach2) continue;
          if (other.strand == own.strand && own.since - other.since < recent) continue;
          if (young && other.strand == own.parent) continue;
          // What creeps on the other side of a thin wall is not in the way.
          if (glm::dot(DVec3(other.normal), normal) < 0) continue;
          double d = std::sqrt(d2);
          view.nearest = std::min(view.nearest, d);
          view.away += way * ((1 - d / spacing_) / std::max(d, 1e-3 * spacing_));
        }
      }
  return view;
}

}  // namespace frond
