#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "dynamics/stand.h"

// The trees that live in a year, and the cells that the land is divided into.

namespace frond {

/// A living tree from breast height on.
struct StandTree {
  std::uint32_t life = 0, species = 0;
  double x = 0, z = 0;
  double born = 0;
  double height = 1.3, diameter = 0.01, crown_radius = 0.5, crown_base = 0.2;  ///< metres
  double talent = 1;  ///< factor of its growth, which it was born with
  double vigour = 1;  ///< its girth's growth against that of a tree in the open, mean of some years
  double site = 1;    ///< the same of its place: 0 too cold, too wet or too dry .. 1

  double crown_length() const { return height - crown_base; }
};

/// Square cells over the land, row by row (z).
struct StandGrid {
  int columns = 1, rows = 1;
  double cell = 2, low_x = 0, low_z = 0;

  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  int column(double x) const { return clamped((x - low_x) / cell, columns); }
  int row(double z) const { return clamped((z - low_z) / cell, rows); }
  bool inside(double x, double z) const {
    return x >= low_x && x < low_x + columns * cell && z >= low_z && z < low_z + rows * cell;
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  /// The cell of a place; beyond the land the nearest one.
  std::size_t at(double x, double z) const { return index(column(x), row(z)); }

 private:
  static int clamped(double x, int count) {
    return std::clamp(static_cast<int>(std::floor(x)), 0, count - 1);
  }
};

StandGrid grid_of(Vec2 area, double cell);

/// Trees by the row of a grid that they stand in, in their order.
class TreeRows {
 public:
  TreeRows(std::span<const StandTree> trees, const StandGrid& grid);
  /// Numbers of the trees in rows `from` to `to`, as far as there are such.
  std::span<const std::uint32_t> in(int from, int to) const;

 private:
  std::vector<std::uint32_t> first_, tree_;
};

/// kg of a fresh stem: 1.8 times its dry mass.
double fresh_mass(const TreeSpecies& species, const StandTree& tree);

}  // namespace frond
