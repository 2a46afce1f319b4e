#pragma once

#include "grove/metamers.h"
#include "grove/species.h"

namespace frond {

/// Sums the light of all living buds from the tips down: into `to_leader` what the axis gathers above each
/// metamer, into `to_side` what its lateral branch or bud does, into `count` the living internodes. Dead ones
/// gather nothing. Returns the light of the whole tree.
float gather_light(Metamers& tree);

/// Apical control of an axis of an order, `age` years into the life of the tree.
double apical_control(const Species& species, double age, int order);

/// Hands `resource` out from the base, where gather_light() has left the light: afterwards `to_leader` and
/// `to_side` hold what reaches the terminal and the lateral bud or branch. What is handed out at each fork is
/// all of what came in.
///
/// Borchert and Honda (1984), extended by Palubicki et al. (2009).
void share_by_forks(Metamers& tree, const Species& species, double age, float resource);

/// The same by priority lists (Palubicki et al. 2009): the terminal bud and the laterals of each axis in the
/// order of their light, with weights that fall from the first to the last.
void share_by_priority(Metamers& tree, const Species& species, double age, float resource);

}  // namespace frond
