#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "dynamics/reef.h"

// The living colonies of a year, and how they compete: for light with what is above them, for space with
// what they touch.

namespace frond {

/// A living colony.
struct Colony {
  std::uint32_t life = 0, species = 0;
  double x = 0, z = 0;
  double born = 0;
  double radius = 0.01, height = 0.01;  ///< metres
  double widest = 0.01;                 ///< metres, the largest radius that it has had
};

/// Colonies by the square cell that their middles are in.
class ColonyGrid {
 public:
  ColonyGrid(std::span<const Colony> colonies, Vec2 area);

  /// Calls `visit(number)` for each colony that may reach a place's surroundings, in an order that depends on
  /// the colonies alone.
  template <class Visit>
  void each_near(double x, double z, double radius, Visit&& visit) const {
    double reach = radius + largest_;
    for (int row = row_of(z - reach); row <= row_of(z + reach); ++row)
      for (int column = column_of(x - reach); column <= column_of(x + reach); ++column) {
        auto cell = static_cast<std::size_t>(row * columns_ + column);
        for (std::uint32_t k = first_[cell]; k < first_[cell + 1]; ++k) visit(colony_[k]);
      }
  }

 private:
  int column_of(double x) const;
  int row_of(double z) const;

  Vec2 area_;
  int columns_ = 1, rows_ = 1;
  double largest_ = 0;  // radius
  std::vector<std::uint32_t> first_, colony_;
};

/// How well a species grows in a light of 0..1, against full light.
double light_response(const ColonySpecies& species, double light);

/// Share of the light, 0..1, that what stands above each colony leaves it.
std::vector<double> light_on(std::span<const Colony> colonies, std::span<const ColonySpecies> species,
                             const ColonyGrid& grid);

/// Grows colonies by a year, `vigour` being how well each grows, 0..1. They grow up as far as there is
/// nothing above them, and at their rims as far as there is room; where two meet, the one of the higher rank
/// overgrows the other, which loses what it covers, and equals stop. No two ever share space.
void grow_year(std::vector<Colony>& colonies, std::span<const ColonySpecies> species, const ColonyGrid& grid,
               std::span<const double> vigour);

}  // namespace frond
