#pragma once

#include <span>

#include "core/seed.h"
#include "grove/light.h"
#include "grove/metamers.h"
#include "grove/species.h"

namespace frond {

/// The conditions of one year's shoots.
struct Season {
  const Species& species;
  const LightField& field;
  Seed seed;  ///< of the tree
  int year = 0;
  std::span<const Vec3> guide = {};  ///< see Seedling
};

/// Measures the light at every living bud, exp(-shadow) by Beer and Lambert, without the shade of its own
/// leaves (`own`). Palubicki et al. use 1 - shadow, which leaves no light inside a crown.
void measure_light(Metamers& tree, const Season& season, float own);

/// Whether a metamer bears leaves at the beginning of a year.
bool bears_leaves(const Metamers& tree, const Species& species, std::size_t i, int year);

/// Each bud with a resource v >= 1 makes floor(v) internodes; `to_leader` and `to_side` hold v. Their
/// direction is the sum of the bud's own, that of the most light, and tropisms (Palubicki et al. 2009,
/// section 4.4). New metamers are appended. `serial` is the next serial number and is advanced. Returns the
/// index of the first new one.
std::size_t grow_shoots(Metamers& tree, const Season& season, std::uint32_t& serial);

}  // namespace frond
