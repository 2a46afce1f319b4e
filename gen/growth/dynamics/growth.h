#pragma once

#include "dynamics/canopy.h"

namespace frond {

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
