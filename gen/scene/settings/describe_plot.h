#pragma once

#include "core/result.h"
#include "land/plot.h"
#include "preset/describe.h"
#include "settings/sky.h"

// The properties of moments, ponds and paths as presets spell them; see preset/describe.h. What is refused of
// paths.

namespace frond {

/// The hours of a day.
inline constexpr Range kHours{.min = 0, .max = 24, .unit = "h", .sense = "dawn is 6, noon 12, dusk 19"};

/// The properties besides the hour that determine the sun's position.
void describe_place(Properties& v, Moment& m);

void describe(Properties& v, PondShape& p);
void describe(Properties& v, PathShape& p);
void describe(Properties& v, GroundArea& a);

/// Errors for paths that are too long, have too many points or leave the land, which reaches `reach` metres
/// from the middle. They are at `pointer`, that of the points.
void check_path(Errors& list, const PathShape& path, const std::string& pointer, double reach);

}  // namespace frond
