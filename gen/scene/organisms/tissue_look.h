#pragma once

#include "core/seed.h"
#include "model/solid.h"
#include "preset/describe.h"

namespace frond {

/// The living skin of colonies that are bodies.
struct TissueLook {
  Color color{0.62f, 0.50f, 0.26f};   ///< of raised parts
  Color second{0.25f, 0.30f, 0.14f};  ///< in cups and valleys
  double cup = 0.008;                 ///< metres, of one polyp's cup, > 0
  double relief = 0.8;                ///< depth of the cups
  double gloss = 0.4;                 ///< 0 matt .. 1 wet
  double variation = 0.12;            ///< variation of brightness between individuals
  Polyps polyps;
};

void describe(Properties& v, TissueLook& t);

/// The material of one colony.
Material material_of(const TissueLook& look, Matter matter, Seed seed);

}  // namespace frond
