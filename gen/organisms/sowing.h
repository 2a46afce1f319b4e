#pragma once

#include "core/vec.h"
#include "land/sow.h"

namespace frond {

/// How colours differ from copy to copy, either way.
struct CopyTint {
  double hue = radians(4.0);  ///< radians
  double saturation = 0.1;    ///< share
  double value = 0.15;        ///< share
};

/// A few models that are grown once and placed often over the land: what makes a forest.
struct Sowing {
  int models = 6;          ///< each by a seed of its own
  std::vector<int> seeds;  ///< of the models, from the first on; beyond them 1, 2, 3, ...
  double crowd = 0;        ///< metres: trees grow up among neighbours at this distance; 0: in the open
  SowRules where;
  CopyTint tint;
  double upright = 1;  ///< 1: as plumb as `place.lean` lets it; 0: across the slope
};

}  // namespace frond
