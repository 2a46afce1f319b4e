#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// How shade decreases below its source.
enum class Fading {
  diffuse,  ///< layer by layer: what a cell loses is shared by the nine cells below it, and 1 / b of it goes
            ///< on
  geometric,  ///< by b^-q, q layers down (Palubicki et al. 2009); by the area of leaves
  even        ///< linearly to 0 at the bottom of the pyramid; by the volume of wood and leaves
};

struct LightLaw {
  double voxel = 0.5;  ///< metres, the side of a cell
  int depth = 8;       ///< layers of a pyramid below the cell that casts it, 1..15
  Fading fading = Fading::diffuse;
  double base = 1.04;   ///< b of the diffuse (just above 1) and of the geometric fading (1.3 to 2)
  double absorb = 0.5;  ///< light lost in a layer of leaves as wide as the cell (k of Beer and Lambert)
};

/// A source of shade: leaves, or any solid.
struct Shade {
  Vec3 at;
  float amount;  ///< share of the light lost right below, see shade_amount
};

/// The shade of an internode with that area of leaves, m2, and volume of wood, m3.
float shade_amount(const LightLaw& law, double leaf_area, double wood_volume);

/// The share of a cell's shade that remains q layers below it.
float fading_weight(const LightLaw& law, int q);

/// Shadow propagation on a sparse grid: each cell with leaves darkens a square pyramid of cells below it
/// (Palubicki et al. 2009, section 4.1.2). Diffuse shade reaches the ground and agrees with Beer and Lambert
/// under a wide canopy; pyramids end at their depth. The field depends only on the current sources and is
/// rebuilt when they change. Memory is used only for shaded tiles of 16 x 16 cells, however wide the land.
class LightField {
 public:
  explicit LightField(const LightLaw& law) : law_(law) {}

  /// Builds the field, down to the height `floor`. `offset` shifts the grid by a part of a cell, so that its
  /// axes leave no pattern in growth over many years. The same bytes at any number of threads.
  void cast(const std::vector<Shade>& shades, float floor, Vec3 offset = Vec3(0));

  /// Light lost at a point, 0 in the open; interpolated between the middles of cells.
  float shadow(Vec3 at) const;

  /// Gradient of the shadow per metre; differences over two cells.
  Vec3 gradient(Vec3 at) const;

  const LightLaw& law() const { return law_; }
  std::size_t tiles() const { return tiles_.size(); }

 private:
  static constexpr int kSide = 16;  // cells of a tile, along x and z

  struct Tile {
    int layer, row, column;
  };

  std::size_t slot(int layer, int row, int column) const {
    return (static_cast<std::size_t>(layer) * rows_ + row) * columns_ + column;
  }
  std::int32_t open_tile(int layer, int row, int column);
  void lay_out(const std::vector<Shade>& shades, float floor);
  void cast_pyramids(const std::vector<float>& amounts);
  void diffuse(const std::vector<float>& amounts);
  bool reaches(std::size_t tile, int row, int column) const;
  void seep(std::size_t tile, float kept, const std::vector<float>& amounts);
  void darken(int layer, const Tile& from, const float* amounts, int q, float weight);
  float cell(int x, int y, int z) const;

  LightLaw law_;
  Vec3 offset_{0};
  glm::ivec3 first_{0};  ///< the first cell of the directory
  int layers_ = 0, rows_ = 0, columns_ = 0;
  std::vector<std::int32_t> directory_;  ///< index of the tile of each 16 x 16 cells of a layer, or -1
  std::vector<Tile> tiles_;
  std::vector<float> shadow_;  ///< shadow of the cells, tile by tile
};

}  // namespace frond
