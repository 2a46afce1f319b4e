#pragma once

#include "core/result.h"
#include "model/model.h"
#include "motion/motion.h"
#include "organisms/body_colony.h"

namespace frond {

/// Materials of tubes.
enum class TubeForm { sponge, pipes };

/// Tubes that grow at their rims, open at the top.
struct TubeParams {
  TubeForm form = TubeForm::sponge;
  double across = 0.3;  ///< metres, of the whole group
  double height = 0.4;  ///< metres
  int tubes = 6;
  double radius = 0.03;     ///< metres, of a tube
  double wall = 0.009;      ///< metres
  double bulge = 0.2;       ///< radians by which a tube widens from its foot
  double lumps = 0.3;       ///< unevenness of the outside
  double lump_size = 0.03;  ///< metres
  int ribs = 0;             ///< along the outside of a tube
  double edge = 0.007;      ///< metres, of triangles
  TissueLook tissue;
  Growth growth;
};

Result<Model> grow_tube(const TubeParams& params, const Surroundings& around, Seed seed);

}  // namespace frond
