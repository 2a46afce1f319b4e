#pragma once

#include "grove/species.h"

namespace frond {

/// The number of growth cycles of a tree of that age, at least one. A cycle makes the shoots of a good year
/// of a young tree. A young tree has `pace` cycles per year. Later a cycle takes more and more years: the
/// number of cycles follows the logarithm of the age, the organic time of Backman (1943), because larger
/// trees grow more slowly (Ryan and Yoder 1997 on height; White 1998 on rings). After its death a cycle is
/// one year, as wood rots in calendar time.
int growth_cycles(const Species& species, double years);

/// The cycle, counted from 0, that a tree is in at an age in years, plus the share of it that is over.
double cycle_at_age(const Species& species, double years);

/// The age in years at which a tree is in a cycle: the inverse of cycle_at_age().
double age_at_cycle(const Species& species, double cycle);

/// A copy of a species with its times in cycles instead of years.
Species in_cycles(const Species& species);

}  // namespace frond
