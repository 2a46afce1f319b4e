#pragma once

#include <vector>

#include "land/plant_grid.h"
#include "land/sow.h"

namespace frond {

/// How well a place suits a kind of plant, crowns of higher layers being where they are.
class Likings {
 public:
  /// What it is given must outlive it.
  Likings(const SowRules& rules, const Land& land, std::span<const PlantGrid> above, Seed seed);

  /// 0: not at all, to 1.
  double operator()(Vec2 at) const;

  /// A place to try.
  struct Dart {
    Vec2 at{0};
    double likely = 0;  ///< how well the places about it suit at best
  };
  /// At random, more where it is liked more: with those kept that are liked more than a random share of
  /// `likely`, they lie as densely as places are liked.
  Dart dart(Seed seed) const;

  /// Whether there is any place to try.
  bool none() const { return until_.empty() || until_.back() <= 0; }

 private:
  double clumps(Vec2 at) const;
  double shade(Vec2 at) const;
  double on_map(Vec2 at) const;
  Vec2 corner(std::size_t i) const;

  const SowRules& rules_;
  const Land& land_;
  std::span<const PlantGrid> above_;
  Seed seed_;
  double relief_ = 0;      // metres, from the lowest to the highest of the land
  double clump_edge_ = 0;  // the noise at the edge of a clump
  Vec2 low_{0};            // of the rectangle that darts are thrown at
  Vec2 step_{0};
  std::vector<double> until_;  // sums over its cells of how well they suit
  std::vector<double> best_;   // of each cell
};

}  // namespace frond
