#pragma once

#include <vector>

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// Two substances that diffuse over a skin and react, and settle into spots or winding ridges (Gray and Scott
/// 1983; Pearson 1993; on meshes: Turk 1991).
struct Reaction {
  double feed = 0.055;
  double kill = 0.062;
  double wave = 0.02;  ///< metres from ridge to ridge, > 0
  int steps = 2600;
  bool fine = false;  ///< whether it begins as many small drops, for cups, or as drops as wide as a wave
};

/// The second substance at each vertex, 0 in valleys .. 1 on ridges, of a closed mesh whose edges are about
/// equally long. A pure function.
std::vector<float> react(const Surface& surface, const Reaction& reaction, Seed seed);

}  // namespace frond
