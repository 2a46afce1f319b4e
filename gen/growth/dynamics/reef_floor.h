#pragma once

#include <span>
#include <vector>

#include "dynamics/contacts.h"

// The ground between colonies: what of it is free, and the algae and the rubble on it.

namespace frond {

/// Shares of a piece of the floor, 0..1.
struct FloorCell {
  double free = 1;        ///< that no colony covers
  double macroalgae = 0;  ///< that macroalgae cover, of the free
  double coralline = 0;   ///< that crustose coralline algae cover, of the free
  double rubble = 0;      ///< of the ground on which loose fragments lie
  /// Of the free ground: how thick macroalgae are.
  double thicket() const { return free > 0 ? macroalgae / free : 0; }
};

/// The floor in cells of equal size, about square.
class ReefFloor {
 public:
  explicit ReefFloor(Vec2 area);

  const FloorCell& at(double x, double z) const;

  /// Finds what the colonies cover, and tells it of the year: shares, rugosity.
  ReefYear survey(std::span<const Colony> colonies, std::span<const ColonySpecies> species);

  /// Lets algae grow for a year, and rubble be bound.
  void grow_year(const ReefOptions& options);

  /// Strews rubble that covers so many m2 about a place; what falls beside the floor is gone.
  void strew(double x, double z, double area);

 private:
  std::size_t index(double x, double z) const;

  Vec2 area_;
  int columns_ = 1, rows_ = 1;
  double wide_ = 0, deep_ = 0;  ///< metres, of a cell along x and z
  std::vector<FloorCell> cells_;
};

}  // namespace frond
