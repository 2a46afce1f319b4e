#pragma once

#include "grove/metamers.h"
#include "grove/species.h"

namespace frond {

/// Sums the light of all living buds from the tips down: `to_leader` is the light gathered by the axis above
/// each metamer, `to_side` that of its lateral branch or bud, `count` the number of living internodes. Dead
/// ones gather nothing. Returns the light of the whole tree.
float gather_light(Metamers& tree);

/// Apical control of an axis of that order, `age` years into the life of the tree.
double apical_control(const Species& species, double age, int order);

/// Distributes `resource` from the base, given the light of gather_light(): afterwards `to_leader` and
/// `to_side` hold the amounts for the terminal and the lateral bud or branch. Each fork passes on exactly
/// what it receives.
///
/// Borchert and Honda (1984), extended by Palubicki et al. (2009).
void share_by_forks(Metamers& tree, const Species& species, double age, float resource);

/// Distributes `resource` as share_by_forks() does, but by priority lists (Palubicki et al. 2009): the
/// terminal bud and the laterals of each axis, sorted by light, with weights that fall to the last.
void share_by_priority(Metamers& tree, const Species& species, double age, float resource);

}  // namespace frond
