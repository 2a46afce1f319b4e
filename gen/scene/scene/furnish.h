#pragma once

#include "preset/fault.h"
#include "scene/preset.h"

namespace frond {

/// The plan of a preset as it was read, by its grammar's seed. Errors are at pointers into the preset.
Result<GroundPlan> plan_of(const PlanText& text);

/// Does what a preset's plan asks for: its ways and rooms become areas of the garden, and what stands in its
/// sites or along them (`place.in`, `place.along`) gets its places there. Errors are at pointers into the
/// preset, whose land reaches `reach` metres from the middle; warnings are added to `warnings`.
Errors furnish(Preset& preset, double reach, Faults& warnings);

}  // namespace frond
