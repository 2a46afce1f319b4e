#pragma once

#include "core/result.h"
#include "model/model.h"
#include "motion/motion.h"
#include "organisms/body_colony.h"

namespace frond {

/// A coral that covers the surface below it, with a lobed, raised edge.
struct EncrustingParams {
  double across = 0.4;       ///< metres
  double height = 0.06;      ///< metres, of the space that it claims
  double lobes = 0.7;        ///< see Margin
  double lobe_size = 0.09;   ///< metres
  double thickness = 0.007;  ///< metres
  double rim = 0.004;        ///< metres by which its edge is raised
  double lumps = 0.3;        ///< unevenness of its upper side
  double edge = 0.006;       ///< metres, of triangles
  TissueLook tissue;
  Growth growth;
};

Result<Model> grow_encrusting(const EncrustingParams& params, const Surroundings& around, Seed seed);

}  // namespace frond
