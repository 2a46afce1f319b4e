#pragma once

#include "core/result.h"
#include "model/model.h"
#include "motion/motion.h"
#include "organisms/body_colony.h"

namespace frond {

/// Surface pattern of a massive coral.
enum class Wrought {
  meander,  ///< valleys that wind between ridges, as on brain corals
  cups,     ///< a cup per polyp with walls shared by neighbours, as on star corals
  plain     ///< fine pores, as on Porites
};

/// A massive coral: a dome, or a heap of domes, with a surface pattern from a reaction of two substances in
/// its skin.
struct MassiveParams {
  double across = 0.36;  ///< metres
  double height = 0.22;  ///< metres
  double lumps = 0.25;   ///< unevenness
  double lump_size = 0.2;
  Wrought relief = Wrought::meander;
  double valley = 0.016;  ///< metres from ridge to ridge
  double depth = 0.006;   ///< metres, of valleys
  double septa = 0;       ///< metres, from septum to septum; 0: none are drawn
  double edge = 0.0032;   ///< metres, of triangles
  TissueLook tissue;
  Growth growth;
};

Result<Model> grow_massive(const MassiveParams& params, const Surroundings& around, Seed seed);

}  // namespace frond
