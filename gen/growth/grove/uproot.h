#pragma once

#include <optional>

#include "core/vec.h"
#include "grove/metamers.h"
#include "grove/species.h"
#include "grove/wood.h"

// Trees that lose their balance. The moment that overturns a tree is in proportion to the mass of its stem;
// in pulling tests on nearly 2000 conifers it was 100 to 200 N m a kg, by species, soil and depth of the
// roots (Nicoll, Gardiner, Rayner and Peace 2006). Windthrow models as ForestGALES count in the same way.

namespace frond {

/// The overturning of a tree.
struct Uprooting {
  float time = Metamers::kNever;  ///< years, when it begins to fall
  Vec3 toward{1, 0, 0};           ///< level, of length 1
  float moment = 0;               ///< N m, of the load
  float hold = 0;                 ///< N m, that the roots held
  bool felled = false;            ///< it is cut above its foot; its roots stay

  bool happens() const { return time != Metamers::kNever; }
};

/// The moment that the roots hold, N m: `anchorage` times the mass of the stem.
double held_moment(const Metamers& tree, const Species& species);

/// Whether the load of a year passes what the roots hold. It then falls at the end of the next year, when
/// what broke off in the storm is down.
Uprooting uprooting_of(const Metamers& tree, const Species& species, const Weather& storm, int year);

/// A tree that is felled in a year: it falls to the side where its weight is, or to the given one.
Uprooting felling_of(const Metamers& tree, const Species& species, std::optional<Vec3> toward, int year);

/// All that lives dies at that time, and nothing grows any more.
void die(Metamers& tree, float time);

}  // namespace frond
