#pragma once

#include "estimate/estimate_cost.h"

namespace frond {

/// How many frames' worth of an organism is not drawn in a part of a film, as it has not grown there yet.
double frames_ungrown(const Film& film, const Growth& growth, FrameRange part);

inline constexpr double kMaskHeld = 4;  ///< bytes of a pixel of a mask

/// Bytes of memory of the masks of the land and of what is sown on it.
struct MaskCostEstimate {
  double held = 0;  ///< from when the preset is read
  double read = 0;  ///< more, while the picture of the largest is
};
MaskCostEstimate estimate_masks(const Preset& preset);

/// Samples of a raw still that are resolved at once; one of more of them is resolved in bands.
inline constexpr double kResolvedWhole = 1e7;

/// Bytes of disk that POV-Ray takes while it traces a picture of a film, beside the picture.
double estimate_tracing_disk(const Film& film);

/// Bytes of memory while a picture of a film is made of raw ones; 0 where none is.
double estimate_resolving(const Preset& preset);

}  // namespace frond
