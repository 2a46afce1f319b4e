#pragma once

#include <optional>

#include "masonry/bridge.h"
#include "model/model.h"

namespace frond {

/// A garden bridge and its materials.
struct BridgeParams {
  BridgeShape shape;
  std::optional<Color> color;   ///< of the wood or stone; none: by the style
  std::optional<Color> second;  ///< of weathered wood, of the mortar
  double variation = 0.16;      ///< variation of brightness between planks or stones
  double weathering = 0.45;     ///< 0 new .. 1 old: greyness and cracks of wood, roughness of stone
  double moss = 0.15;           ///< 0 none .. 1
  double gloss = 0.04;          ///< 0 raw .. 1 oiled
};

/// Builds one with its middle over the origin and its feet at y = 0.
Model grow_bridge(const BridgeParams& params, Seed seed);

}  // namespace frond
