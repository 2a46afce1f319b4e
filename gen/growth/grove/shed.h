#pragma once

#include "core/seed.h"
#include "grove/metamers.h"
#include "grove/species.h"
#include "grove/wood.h"

namespace frond {

/// Kills branches that gather too little light for their size (Takenaka 1994), and the whole tree if that is
/// true of all of it or its life is over. Needs the sums of gather_light(). Gives how many metamers died.
std::size_t die_of_shade(Metamers& tree, const Species& species, Seed seed, int year, double age);

/// The effect of the storm of a year on the wood.
struct Strain {
  std::vector<float> radius;  ///< of each metamer, metres
  std::vector<float> stress;  ///< Pa; slender wood bends until it lies in the wind, and no further
};

Strain strain_of(const Metamers& tree, const Species& species, const Weather& storm, int year);

/// Strained stems thicken (Metzger 1893; Jaffe 1973): toward the radius at which the storm takes 0.4 of their
/// strength, by at most 1.4 times a year. The stress is updated.
void brace(Metamers& tree, const Wood& wood, Strain& strain);

/// The parts that fall off in a year.
struct Falls {
  std::vector<float> time;  ///< of each metamer, years, or Metamers::kNever; equal for all of one piece
  std::size_t broken = 0;   ///< number of living pieces that the storm broke
  bool stem = false;        ///< the storm broke off more than half of the tree
};

/// Finds the parts that fall: rotten dead wood, twigs before limbs, and wood bent beyond its strength by the
/// weather. Dead wood loses its strength as it rots.
Falls find_falls(const Metamers& tree, const Species& species, const Strain& strain, Seed seed, int year);

}  // namespace frond
