#pragma once

#include "grove/species.h"

namespace frond {

/// The growth cycles that a tree of some years has gone through, at least one. A grove grows in cycles: one
/// makes the shoots of a good year of a young tree. While a tree is young it goes through `pace` of them a
/// year. Later it takes the more years for each the older it is: its cycles go by the logarithm of its age,
/// the organic time of Backman (1943), for an old tree pays for its size with its growth (Ryan and Yoder 1997
/// on height; White 1998 on rings). From its death on a year is a cycle, as wood rots by the calendar.
int growth_cycles(const Species& species, double years);

/// The same species counted in cycles: a year of its life is one.
Species in_cycles(const Species& species);

}  // namespace frond
