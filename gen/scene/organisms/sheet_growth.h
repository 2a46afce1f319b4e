#pragma once

#include "accretion/accretion.h"
#include "accretion/sheet_body.h"
#include "organisms/colony.h"

// Functions shared by kinds of bodies that grow at a margin or by layers.

namespace frond {

/// The room left for sheets by the colony's surroundings, which must outlive it.
MarginWorld margin_world(const Surroundings& around);

/// A ring, or an arc of one, about a middle: `turn` is the direction of the arc's middle, `arc` its angle,
/// radians; it grows outward, `pitch` radians above the horizon.
MarginStart ring_start(Vec3 middle, double radius, double turn, double arc, double pitch, double edge);

/// Adds a body to another.
void append(SheetBody& to, const SheetBody& more);

/// The error for triangles longer than a `parts`-th of the width.
Errors check_edge(double edge, double across, double parts);

/// Predicted size of a sheet with that area and edge length, counting both sides.
SizeEstimate estimate_surface(double area, double edge);

/// Memory of a body's past, bytes per triangle.
inline constexpr double kPastTriangle = 250;

/// Predicted size of a skin that grows by layers, from its final area, m2.
SizeEstimate estimate_surface(const Accretion& law, double area);

/// The surroundings for a skin that grows by layers.
AccretionWorld accretion_world(const Surroundings& around);

/// A body of one living skin, with its past, see Solid::past.
Model model_of(Surface skin, std::vector<std::vector<Vec3>> past, const Material& material);

/// The body of a sheet as a model.
Model model_of(SheetBody body, const Material& material);

}  // namespace frond
