#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "dynamics/stand.h"

// The trees that live in a year, the cells that the land is divided into, the light there, and how trees grow
// in it. Leaves are spread evenly over crowns, which are paraboloids; light comes from the whole sky, loses
// by Beer's law what leaves take, and spreads to the sides as it comes down.

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

/// Light on its way through a layer of leaves is exp(-kExtinction * m2 of leaves over a m2).
inline constexpr double kExtinction = 0.5;

/// The leaves and the light of a year, in layers over the ground.
struct Canopy {
  static constexpr double kLayer = 2;  ///< metres

  StandGrid grid;
  int layers = 1;
  /// Share of light, 0..1, at the foot of each layer and above the last; layer by layer, cell by cell.
  std::vector<float> light{};
  std::vector<float> top{};  ///< metres, of each cell: its highest crown

  double ground_light(std::size_t cell) const { return static_cast<double>(light[cell]); }
  /// Share of light, 0..1, in a cell at a height in metres, or up to a layer above it.
  double light_above(std::size_t cell, double height) const {
    int layer = std::clamp(static_cast<int>(height / kLayer) + 1, 0, layers);
    return static_cast<double>(light[static_cast<std::size_t>(layer) * grid.size() + cell]);
  }
};

/// The canopy of these trees; the same with any number of threads.
Canopy canopy_of(std::span<const StandTree> trees, std::span<const TreeSpecies> species,
                 const StandGrid& grid);

/// How well a species grows in a light of 0..1, against full light: between the curves of JABOWA (Botkin,
/// Janak and Wallis 1972) for trees that bear shade and that do not, by its tolerance.
double light_response(const TreeSpecies& species, double light);

/// How well it grows at a temperature and moisture, 0..1: from its tree line to 4 degrees above it, and about
/// the moisture that it likes.
double site_response(const TreeSpecies& species, double temperature, double moisture);

/// Radius of the crown at a diameter, metres.
double crown_radius_at(const TreeSpecies& species, double diameter);

/// Grows a tree by a year. Girth follows the light on its crown and the length of that; height only falls
/// behind in deep shade, or where the stem is too slender, so trees in the dark are slender. Its lowest
/// branches die where they get less light than they had at the foot of a crown in the open.
void grow_year(StandTree& tree, const TreeSpecies& species, const Canopy& canopy);

}  // namespace frond
