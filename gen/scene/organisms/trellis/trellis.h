#pragma once

#include "core/seed.h"
#include "masonry/trellis.h"
#include "model/model.h"

namespace frond {

/// A trellis of timber and wire.
struct TrellisParams {
  TrellisShape shape;
  Color color{0.50f, 0.40f, 0.30f};   ///< of the wood
  Color second{0.55f, 0.53f, 0.49f};  ///< of weathered wood
  Color metal{0.42f, 0.43f, 0.44f};   ///< of the wires
  double variation = 0.12;            ///< variation of brightness between pieces
  double weathering = 0.5;            ///< 0 new .. 1 old
  double moss = 0.1;                  ///< 0 none .. 1
};

/// It stands along x with the middle of its foot at the origin, its front toward +z; each part is closed.
Model build_trellis_model(const TrellisParams& params, Seed seed);

}  // namespace frond
