#pragma once

#include <vector>

#include "core/discrete_distribution.h"
#include "land/plant_grid.h"
#include "land/sow.h"

namespace frond {

/// How well places suit a kind of plant, given the crowns of higher layers.
class Suitability {
 public:
  /// The arguments must outlive it.
  Suitability(const SowRules& rules, const Land& land, std::span<const PlantGrid> above, Seed seed);

  /// 0: not at all .. 1.
  double operator()(Vec2 at) const;

  /// A candidate position.
  struct Dart {
    Vec2 at{0};
    double likely = 0;  ///< upper bound of how well its surroundings suit
  };
  /// A random candidate, more likely where places suit better. If a candidate is kept only when its own value
  /// exceeds a random share of `likely`, the density of plants is proportional to how well places suit.
  Dart dart(Seed seed) const;

  /// Whether there are no candidates at all.
  bool none() const { return lots_.sum() <= 0; }

 private:
  double clumps(Vec2 at) const;
  double shade(Vec2 at) const;
  Vec2 corner(std::size_t i) const;

  const SowRules& rules_;
  const Land& land_;
  std::span<const PlantGrid> above_;
  Seed seed_;
  double relief_ = 0;      // metres, height range of the land
  double clump_edge_ = 0;  // value of the noise at the edge of a clump
  Vec2 low_{0};            // of the rectangle that candidates are drawn from
  Vec2 step_{0};
  DiscreteDistribution lots_;  // of its cells, by how well they suit
  std::vector<double> best_;   // highest value of each cell
};

}  // namespace frond
