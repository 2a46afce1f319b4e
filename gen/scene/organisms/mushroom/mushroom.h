#pragma once

#include "core/result.h"
#include "model/model.h"
#include "motion/motion.h"
#include "organisms/body_colony.h"

namespace frond {

/// A mushroom coral: one large polyp, an oval dome of radial septa that lies loose on the ground.
struct MushroomParams {
  double across = 0.16;   ///< metres, its length
  double height = 0.036;  ///< metres
  double oval = 0.75;     ///< width relative to the length
  int septa = 36;         ///< of the first order
  double depth = 0.006;   ///< metres, of the valleys between septa
  TissueLook tissue;
  Growth growth;
};

Result<Model> grow_mushroom(const MushroomParams& params, const Surroundings& around, Seed seed);

}  // namespace frond
