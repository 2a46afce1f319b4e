#pragma once

#include <optional>
#include <vector>

#include "core/vec.h"
#include "land/sow.h"

namespace frond {

/// Random colour differences between copies, plus or minus.
struct CopyTint {
  double hue = radians(4.0);  ///< radians
  double saturation = 0.1;    ///< share
  double value = 0.15;        ///< share
};

/// What a model is fitted to, metres.
struct ModelSize {
  float height = 1, crown = 1;  ///< the latter the radius within which most of it stands
  float stem = 0.1f;            ///< diameter of its foot
};

/// A few models that are grown once and placed many times over the land, as in a forest.
struct Sowing {
  int models = 6;          ///< each with its own seed
  std::vector<int> seeds;  ///< of the first models; the others get 1, 2, 3, ...
  double crowd = 0;        ///< metres: trees grow among neighbours at this distance; 0: without neighbours
  SowRules where;
  CopyTint tint;
  std::optional<ModelSize> size;  ///< that all models are fitted to; none: they are as they grow
  double upright = 1;             ///< 1: as vertical as `place.lean` allows; 0: at right angles to the slope
  std::optional<Vec2>
      present;  ///< part of the year, 0..1, in which copies are above the ground; none: always
};

}  // namespace frond
