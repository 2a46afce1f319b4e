#pragma once

#include "grammar/grammar.h"
#include "motion/motion.h"
#include "organisms/colony.h"

namespace frond {

/// What answers the questions `?E` of a grammar whose turtle draws in metres: `?E(0, light)` the share of the
/// sky that bodies leave open, 0..1; `?E(1, distance, x, y, z)` metres to what is nearest of the ground,
/// bodies that stand and borders of neighbours' territories, and the direction away from it; `?E(2, distance,
/// x, y, z)` metres to the food, where it is when growth ends, and the direction toward it. What is asked
/// otherwise, or of food that has no strength, keeps its parameters. The surroundings must outlive it.
Environment environment_of(const Surroundings& around, const Food& food, const Growth& growth);

/// The fault of a grammar that asks and is scaled afterwards: distances would mean nothing.
Errors check_asking(const Grammar& grammar, double height);

}  // namespace frond
