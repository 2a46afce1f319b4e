#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// How shade fades below what casts it.
enum class Fading {
  diffuse,  ///< layer by layer: what a cell loses is shared by the nine cells below it, and 1 / b of it goes
            ///< on
  geometric,  ///< by b^-q, q layers down (Palubicki et al. 2009); what shades is the area of leaves
  even  ///< linearly to nothing at the foot of the pyramid; what shades is the volume of wood and leaves
};

struct LightLaw {
  double voxel = 0.5;  ///< metres, the side of a cell
  int depth = 8;       ///< layers of a pyramid below the cell that casts it, 1..15
  Fading fading = Fading::diffuse;
  double base = 1.04;   ///< b of the diffuse (just above 1) and of the geometric fading (1.3 to 2)
  double absorb = 0.5;  ///< light lost in a layer of leaves as wide as the cell (k of Beer and Lambert)
};

/// What casts shade: leaves, or anything that stands there.
struct Shade {
  Vec3 at;
  float amount;  ///< of the light lost right below, see shade_amount
};

/// What an internode takes of the light: leaves of so many square metres and so many cubic metres of wood.
float shade_amount(const LightLaw& law, double leaf_area, double wood_volume);

/// What a pyramid has left of the shade of its cell, q layers below it.
float fading_weight(const LightLaw& law, int q);

/// Shadow propagation on a sparse grid: each cell that holds leaves darkens a square pyramid of cells below
/// it (Palubicki et al. 2009, section 4.1.2). Diffuse shade reaches the ground, and under a wide roof of
/// leaves it is that of Beer and Lambert; the pyramids are cut off at their depth. The field is a function of
/// what casts shade now, made anew when that changes. Memory is for tiles of 16 x 16 cells that are shaded,
/// however wide the land between trees.
class LightField {
 public:
  explicit LightField(const LightLaw& law) : law_(law) {}

  /// Makes the field. Nothing is kept below `floor`. `offset` shifts the grid by a part of a cell, so that
  /// its axes leave no mark on what grows for many years. Same bytes at any number of threads.
  void cast(const std::vector<Shade>& shades, float floor, Vec3 offset = Vec3(0));

  /// Light lost at a place, 0 in the open; interpolated between the middles of cells.
  float shadow(Vec3 at) const;

  /// How the shadow grows, for each metre along the axes; differences over two cells.
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
  glm::ivec3 first_{0};  ///< the cell at which the directory begins
  int layers_ = 0, rows_ = 0, columns_ = 0;
  std::vector<std::int32_t> directory_;  ///< tile of each 16 x 16 cells of a layer, or -1
  std::vector<Tile> tiles_;
  std::vector<float> shadow_;  ///< of the cells, tile by tile
};

}  // namespace frond
