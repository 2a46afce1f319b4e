#pragma once

#include "grammar/grammar.h"
#include "motion/motion.h"
#include "organisms/colony.h"

namespace frond {

/// The environment that answers the questions `?E` of a grammar whose turtle draws in metres: `?E(0, light)`
/// the share of the sky that bodies leave open, 0..1; `?E(1, distance, x, y, z)` metres to the nearest of the
/// ground, existing bodies and borders of neighbours' territories, and the direction away from it; `?E(2,
/// distance, x, y, z)` metres to the food at its position when growth ends, and the direction toward it. Any
/// other question, or one about food without strength, leaves its parameters unchanged. The surroundings must
/// outlive it.
Environment environment_of(const Surroundings& around, const Food& food, const Growth& growth);

/// Whether a grammar asks them.
bool asks(const GrammarText& text);

/// The error of a grammar that asks questions and is scaled afterwards, which would make distances
/// meaningless.
Errors check_asking(const Grammar& grammar, double height);

}  // namespace frond
