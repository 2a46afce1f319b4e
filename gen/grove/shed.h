#pragma once

#include "core/seed.h"
#include "grove/metamers.h"
#include "grove/species.h"
#include "grove/wood.h"

namespace frond {

/// Lets branches die that gather too little light for their size (Takenaka 1994), and the whole tree where
/// all of it does or its life is over. Needs the sums of gather_light(). Returns how many metamers died.
std::size_t die_of_shade(Metamers& tree, const Species& species, Seed seed, int year, double age);

/// What the storm of a year does to the wood.
struct Strain {
  std::vector<float> radius;  ///< of each metamer, metres
  std::vector<float> stress;  ///< Pa; what is slender bends over until it lies in the wind, and no further
};

Strain strain_of(const Metamers& tree, const Species& species, const Weather& storm, int year);

/// A stem that is strained thickens where it is (Metzger 1893; Jaffe 1973): toward the radius at which the
/// storm takes 0.4 of its strength, by at most 1.4 times a year. The stress goes down with it.
void brace(Metamers& tree, const Wood& wood, Strain& strain);

/// What leaves the tree in a year.
struct Falls {
  std::vector<float> time;  ///< of each metamer, years, or Metamers::kNever; all of one piece at one time
  std::size_t broken = 0;   ///< pieces that the storm broke, dead ones not counted
  bool stem = false;        ///< the storm broke off more than half of the tree
};

/// What drops: dead wood that has rotted through, twigs before limbs, and what bends past its strength in
/// the weather. Dead wood loses its strength as it rots.
Falls find_falls(const Metamers& tree, const Species& species, const Strain& strain, Seed seed, int year);

}  // namespace frond
