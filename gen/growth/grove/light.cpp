#include "grove/light.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr int kSpread = 2;          // tiles beyond what casts it that diffuse shade may reach
constexpr float kFaint = 1e-3f;     // shade that is let go at the edge of a tile
constexpr double kLeafDepth = 0.1;  // metres: how thick the leaves of an internode lie
constexpr double kFilling = 4;      // shade of a cell that is full of wood and leaves, in units of `absorb`

int floor_int(float x) { return static_cast<int>(std::floor(x)); }

/// The tile that a cell lies in, and the cell's place in it.
int tile_of(int cell) { return cell >> 4; }
int place_in(int cell) { return cell & 15; }

}  // namespace

float fading_weight(const LightLaw& law, int q) {
  assert(q >= 0 && q <= law.depth);
  if (law.fading == Fading::geometric) return static_cast<float>(std::pow(law.base, -q));
  return 1 - static_cast<float>(q) / static_cast<float>(law.depth + 1);
}

float shade_amount(const LightLaw& law, double leaf_area, double wood_volume) {
  assert(law.voxel > 0 && leaf_area >= 0 && wood_volume >= 0);
  double h = law.voxel;
  if (law.fading != Fading::even) return static_cast<float>(law.absorb * leaf_area / (h * h));
  return static_cast<float>(law.absorb * kFilling * (leaf_area * kLeafDepth + wood_volume) / (h * h * h));
}

std::int32_t LightField::open_tile(int layer, int row, int column) {
  assert(layer >= 0 && layer < layers_);
  assert(row >= 0 && row < rows_ && column >= 0 && column < columns_);
  std::int32_t& entry = directory_[slot(layer, row, column)];
  if (entry < 0) {
    entry = static_cast<std::int32_t>(tiles_.size());
    tiles_.push_back({layer, row, column});
  }
  return entry;
}

/// The directory of all tiles that the shades may reach.
void LightField::lay_out(const std::vector<Shade>& shades, float floor) {
  assert(!shades.empty() && std::isfinite(floor));
  Vec3 low = shades[0].at, high = low;
  for (const Shade& s : shades) low = glm::min(low, s.at), high = glm::max(high, s.at);
  low.y = std::min(floor, low.y);
  float h = static_cast<float>(law_.voxel);
  Vec3 from = (low - offset_) / h, to = (high - offset_) / h;
  int margin = law_.fading == Fading::diffuse ? kSpread : 1;  // tiles
  first_ = {(tile_of(floor_int(from.x)) - margin) * kSide, floor_int(from.y),
            (tile_of(floor_int(from.z)) - margin) * kSide};
  columns_ = tile_of(floor_int(to.x) - first_.x) + 1 + margin;
  rows_ = tile_of(floor_int(to.z) - first_.z) + 1 + margin;
  layers_ = floor_int(to.y) - first_.y + 1;
  directory_.assign(slot(layers_, 0, 0), -1);
  tiles_.clear();
}

/// Adds the shade of one tile to a layer q below it.
void LightField::darken(int layer, const Tile& from, const float* amounts, int q, float weight) {
  assert(layer >= 0 && layer <= from.layer && q < kSide && "a shadow stays within the next tiles");
  for (int cell = 0; cell < kSide * kSide; ++cell) {
    if (amounts[cell] == 0) continue;
    float shade = amounts[cell] * weight;
    int x = from.column * kSide + place_in(cell), z = from.row * kSide + (cell >> 4);
    for (int row = z - q; row <= z + q; ++row) {
      for (int left = x - q; left <= x + q;) {
        int right = std::min(x + q, left | 15);
        float* to = &shadow_[static_cast<std::size_t>(directory_[slot(layer, tile_of(row), tile_of(left))]) *
                                 (kSide * kSide) +
                             place_in(row) * kSide];
        for (int k = place_in(left), end = place_in(right); k <= end; ++k) to[k] += shade;
        left = right + 1;
      }
    }
  }
}

void LightField::cast(const std::vector<Shade>& shades, float floor, Vec3 offset) {
  offset_ = offset * static_cast<float>(law_.voxel);
  if (shades.empty()) {
    layers_ = rows_ = columns_ = 0;
    tiles_.clear();
    return;
  }
  lay_out(shades, floor);

  std::vector<float> amounts;
  float h = static_cast<float>(law_.voxel);
  for (const Shade& s : shades) {
    Vec3 p = (s.at - offset_) / h;
    int x = floor_int(p.x) - first_.x, y = floor_int(p.y) - first_.y, z = floor_int(p.z) - first_.z;
    auto tile = static_cast<std::size_t>(open_tile(y, tile_of(z), tile_of(x)));
    if (amounts.size() < tiles_.size() * kSide * kSide) amounts.resize(tiles_.size() * kSide * kSide, 0.0f);
    amounts[tile * kSide * kSide + place_in(z) * kSide + place_in(x)] += s.amount;
  }
  if (law_.fading == Fading::diffuse)
    diffuse(amounts);
  else
    cast_pyramids(amounts);
}

void LightField::cast_pyramids(const std::vector<float>& amounts) {
  assert(law_.depth >= 1 && law_.depth <= 15);
  assert(amounts.size() == tiles_.size() * kSide * kSide);
  // A shadow is less than a tile wide to each side.
  std::size_t casting = tiles_.size();
  std::vector<std::vector<std::uint32_t>> of_layer(static_cast<std::size_t>(layers_));
  for (std::size_t i = 0; i < casting; ++i) {
    Tile t = tiles_[i];
    of_layer[t.layer].push_back(static_cast<std::uint32_t>(i));
    for (int layer = t.layer; layer >= std::max(0, t.layer - law_.depth); --layer)
      for (int row = t.row - 1; row <= t.row + 1; ++row)
        for (int column = t.column - 1; column <= t.column + 1; ++column) open_tile(layer, row, column);
  }
  shadow_.assign(tiles_.size() * kSide * kSide, 0.0f);

  parallel_for(static_cast<std::size_t>(layers_), [&](std::size_t at) {
    int layer = static_cast<int>(at);
    for (int q = 0; q <= law_.depth && layer + q < layers_; ++q)
      for (std::uint32_t i : of_layer[layer + q])
        darken(layer, tiles_[i], &amounts[std::size_t{i} * kSide * kSide], q, fading_weight(law_, q));
  });
}

/// Fills a tile from the layer above and from what casts shade in it.
void LightField::seep(std::size_t tile, float kept, const std::vector<float>& amounts) {
  constexpr int kWide = kSide + 2;
  Tile t = tiles_[tile];
  float above[kWide][kWide];
  for (int r = 0; r < kWide; ++r)
    for (int c = 0; c < kWide; ++c)
      above[r][c] = cell(t.column * kSide + c - 1, t.layer + 1, t.row * kSide + r - 1);
  const float* own = (tile + 1) * kSide * kSide <= amounts.size() ? &amounts[tile * kSide * kSide] : nullptr;
  float* to = &shadow_[tile * kSide * kSide];
  for (int r = 0; r < kSide; ++r) {
    for (int c = 0; c < kSide; ++c) {
      float sum = 0;
      for (int dr = 0; dr < 3; ++dr) sum += above[r + dr][c] + above[r + dr][c + 1] + above[r + dr][c + 2];
      to[r * kSide + c] = sum * kept + (own ? own[r * kSide + c] : 0.0f);
    }
  }
}

void LightField::diffuse(const std::vector<float>& amounts) {
  auto kept = static_cast<float>(1 / law_.base / 9);
  std::vector<std::vector<std::uint32_t>> of_layer(static_cast<std::size_t>(layers_));
  for (std::size_t i = 0; i < tiles_.size(); ++i)
    of_layer[tiles_[i].layer].push_back(static_cast<std::uint32_t>(i));
  shadow_.assign(amounts.size(), 0.0f);
  for (int layer = layers_ - 1; layer >= 0; --layer) {
    auto& here = of_layer[layer];
    if (layer + 1 < layers_) {
      for (std::uint32_t i : of_layer[layer + 1]) {
        Tile t = tiles_[i];
        for (int row = t.row - 1; row <= t.row + 1; ++row) {
          for (int column = t.column - 1; column <= t.column + 1; ++column) {
            if (!reaches(i, row - t.row, column - t.column)) continue;
            if (row < 0 || row >= rows_ || column < 0 || column >= columns_) continue;
            std::size_t before = tiles_.size();
            std::int32_t tile = open_tile(layer, row, column);
            if (tiles_.size() > before) here.push_back(static_cast<std::uint32_t>(tile));
          }
        }
      }
    }
    shadow_.resize(tiles_.size() * kSide * kSide, 0.0f);
    parallel_for(here.size(), [&](std::size_t k) { seep(here[k], kept, amounts); });
  }
}

/// Whether what is in a tile goes on into the one below it, `row` and `column` (-1, 0, 1) aside.
bool LightField::reaches(std::size_t tile, int row, int column) const {
  const float* cells = &shadow_[tile * kSide * kSide];
  assert(tile < tiles_.size() && row >= -1 && row <= 1 && column >= -1 && column <= 1);
  int r0 = row > 0 ? kSide - 1 : 0, r1 = row < 0 ? 0 : kSide - 1;
  int c0 = column > 0 ? kSide - 1 : 0, c1 = column < 0 ? 0 : kSide - 1;
  for (int r = r0; r <= r1; ++r)
    for (int c = c0; c <= c1; ++c)
      if (cells[r * kSide + c] > kFaint) return true;
  return false;
}

float LightField::cell(int x, int y, int z) const {
  if (y < 0 || y >= layers_) return 0;
  int row = tile_of(z), column = tile_of(x);
  if (row < 0 || row >= rows_ || column < 0 || column >= columns_) return 0;
  std::int32_t tile = directory_[slot(y, row, column)];
  return tile < 0
             ? 0.0f
             : shadow_[static_cast<std::size_t>(tile) * (kSide * kSide) + place_in(z) * kSide + place_in(x)];
}

float LightField::shadow(Vec3 at) const {
  assert(std::isfinite(glm::dot(at, at)));
  if (layers_ == 0) return 0;
  Vec3 p = (at - offset_) / static_cast<float>(law_.voxel) - 0.5f;
  int x = floor_int(p.x), y = floor_int(p.y), z = floor_int(p.z);
  float fx = p.x - static_cast<float>(x), fy = p.y - static_cast<float>(y), fz = p.z - static_cast<float>(z);
  x -= first_.x, y -= first_.y, z -= first_.z;
  auto layer = [&](int level) {
    float near = cell(x, level, z) * (1 - fx) + cell(x + 1, level, z) * fx;
    float far = cell(x, level, z + 1) * (1 - fx) + cell(x + 1, level, z + 1) * fx;
    return near * (1 - fz) + far * fz;
  };
  return layer(y) * (1 - fy) + layer(y + 1) * fy;
}

Vec3 LightField::gradient(Vec3 at) const {
  float h = static_cast<float>(law_.voxel);
  Vec3 slope;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 step(0);
    step[axis] = h;
    slope[axis] = (shadow(at + step) - shadow(at - step)) / (2 * h);
  }
  return slope;
}

}  // namespace frond
