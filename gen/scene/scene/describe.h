#pragma once

#include "preset/describe.h"
#include "scene/preset.h"

// The outline of presets; see preset/describe.h.

namespace frond {

inline constexpr Choice<Quality> kQualities[] = {{"draft", Quality::draft, "a few seconds a frame"},
                                                 {"good", Quality::good, "smooth edges, soft shadows"},
                                                 {"best", Quality::best, "everything, slow"}};

/// The sides of a picture.
inline constexpr Range kSides{.min = 16, .max = 16384, .unit = "pixels"};

void describe(Properties& v, PlanText& p);
void describe(Properties& v, StandText& s);
void describe(Properties& v, ReefText& r);
void describe(Properties& v, Preset& p);

}  // namespace frond
