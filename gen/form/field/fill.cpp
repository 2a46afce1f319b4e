#include <algorithm>
#include <array>
#include <limits>

#include "field/blocks.h"

namespace frond {

namespace {

constexpr float kFarAway = std::numeric_limits<float>::max();
using Row = std::array<float, kPartSide>;

/// Lowers a row of voxels to the distance of one cone; written so that the compiler makes vectors of it.
void lower_row(const RoundCone& cone, Vec3 at, float voxel, Row& row) {
  Vec3 away = at - cone.from;
  float flat2 = away.x * away.x + away.y * away.y, flat_along = away.x * cone.axis.x + away.y * cone.axis.y;
  float axis_z = cone.axis.z, lean = cone.lean, length = cone.length, radius = cone.radius,
        taper = cone.taper;
  for (int k = 0; k < kPartSide; ++k) {
    float z = away.z + voxel * static_cast<float>(k);
    float along = flat_along + z * axis_z;
    float across = flat2 + z * z - along * along;
    across = std::sqrt(across > 0 ? across : 0);
    float foot = along - across * lean;
    foot = foot > 0 ? foot : 0;
    foot = foot < length ? foot : length;
    float rest = along - foot;
    float d = std::sqrt(across * across + rest * rest) - (radius - taper * foot);
    float& value = row[k];
    value = d < value ? d : value;
  }
}

/// A row of an arm: the nearest cone of each voxel.
struct ArmRow {
  Row distance;
  std::array<std::uint32_t, kPartSide> cone;
};

ArmRow arm_row(const BranchVolume& boughs, const Forks& forks, const Arm& arm, Vec3 at, float voxel) {
  ArmRow best;
  best.distance.fill(kFarAway), best.cone.fill(0);
  for (std::uint32_t m = arm.first; m < arm.last; ++m) {
    Row before = best.distance;
    lower_row(boughs.cones[forks.member[m]], at, voxel, best.distance);
    for (std::size_t k = 0; k < before.size(); ++k)
      best.cone[k] = best.distance[k] < before[k] ? forks.member[m] : best.cone[k];
  }
  return best;
}

/// Lowers a row to the fillets of one fork.
void lower_to_fork(const BranchVolume& boughs, const Forks& forks, std::size_t f, Vec3 at, float voxel,
                   float band, Row& row) {
  const Forks::Fork& fork = forks.forks[f];
  std::array<ArmRow, kMostArms> arms;
  Row least;
  least.fill(kFarAway);
  float width = 0;
  std::size_t count = fork.last - fork.first;
  for (std::size_t a = 0; a < count; ++a) {
    const Arm& arm = forks.arms[fork.first + a];
    arms[a] = arm_row(boughs, forks, arm, at, voxel);
    for (std::size_t k = 0; k < least.size(); ++k) least[k] = std::min(least[k], arms[a].distance[k]);
    width = std::max(width, arm.width);
  }
  for (std::size_t k = 0; k < row.size(); ++k) {
    int close = 0;
    for (std::size_t a = 0; a < count; ++a) close += arms[a].distance[k] - least[k] < width;
    // Deep inside nothing is asked, and else only where arms are near each other and low enough to matter.
    float reach = static_cast<float>(close * (close - 1)) / 8 * width;
    if (row[k] <= -band || close < 2 || least[k] - reach >= std::min(band, row[k])) continue;
    std::array<Nearest, kMostArms> near;
    for (std::size_t a = 0; a < count; ++a) near[a] = {arms[a].distance[k], arms[a].cone[k]};
    Vec3 place = at + Vec3(0, 0, voxel * static_cast<float>(k));
    row[k] =
        std::min(row[k], blend_arms(boughs, forks, f, std::span(near.data(), count), place, false).distance);
  }
}

/// Fills one part of a block.
void fill_part(const BranchVolume& boughs, float voxel, float band, const Nearby& near, Cell first,
               float* out) {
  for (int i = 0; i < kPartSide; ++i)
    for (int j = 0; j < kPartSide; ++j) {
      Vec3 at = voxel_middle({first.i + i, first.j + j, first.k}, voxel);
      Row row;
      row.fill(kFarAway);
      for (std::uint32_t c : near.cones) lower_row(boughs.cones[c], at, voxel, row);
      for (std::size_t f = 0; f < near.forks.size(); ++f)
        lower_to_fork(boughs, near.forks, f, at, voxel, band, row);
      for (int k = 0; k < kPartSide; ++k)
        out[(i * kBlockSide + j) * kBlockSide + k] = std::clamp(row[k], -band, band);
    }
}

}  // namespace

Filling fill_block(const BranchVolume& boughs, const Blocks& blocks, const FoundBlock& found,
                   std::span<float, kBlockVoxels> distance) {
  float voxel = blocks.voxel, band = blocks.band;
  Cell first = block_origin(found.block->key);
  Nearby listed, whole, part;
  near_block(boughs, blocks, found, listed);
  choose_near(boughs, listed, cube_middle(first, kBlockSide, voxel), cube_reach(kBlockSide, voxel), band,
              whole);
  if (whole.middle + cube_reach(kBlockSide, voxel) < -band) return Filling::inside;
  for (int p = 0; p < 8; ++p) {
    int i = p >> 2 & 1, j = p >> 1 & 1, k = p & 1;
    Cell from{first.i + i * kPartSide, first.j + j * kPartSide, first.k + k * kPartSide};
    choose_near(boughs, whole, cube_middle(from, kPartSide, voxel), cube_reach(kPartSide, voxel), band, part);
    fill_part(boughs, voxel, band, part, from,
              distance.data() + ((i * kBlockSide + j) * kBlockSide + k) * kPartSide);
  }
  bool in_band = false, deep = true;
  for (float d : distance) {
    in_band |= d > -band && d < band;
    deep &= d <= -band;
  }
  return in_band ? Filling::crossed : deep ? Filling::inside : Filling::outside;
}

}  // namespace frond
