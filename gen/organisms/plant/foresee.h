#pragma once

#include "organisms/grower.h"
#include "organisms/plant/plant.h"

namespace frond {

/// Adds what a grammar hangs on its branches: as counted where it is small, and on a smaller one otherwise.
void count_organs(const PlantParams& params, Seed seed, Foresight& plant);

}  // namespace frond
