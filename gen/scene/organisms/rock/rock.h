#pragma once

#include "organisms/stone_look.h"

namespace frond {

/// One rock.
struct RockParams {
  RockShape shape;
  StoneLook stone;
  double buried = 0.06;  ///< share of its height below the ground
  bool native = false;   ///< drawn as an isosurface: only the blobs, exact and without weathering
};

/// Builds a rock, its foot at the origin. Blobs without an inside are an error.
Result<Model> build_rock(const RockParams& params, Seed seed);

}  // namespace frond
