#pragma once

#include "accretion/accretion.h"
#include "accretion/sheet_body.h"
#include "organisms/colony.h"

// What kinds that grow at a margin share.

namespace frond {

/// The room that a colony leaves for them. The surroundings must outlive it.
MarginWorld margin_world(const Surroundings& around);

/// Half a thickness that goes from `young` to `old` with age.
std::function<float(std::uint32_t, float)> half_thickness(double young, double old);

/// A ring, or a part of one, about a middle: `turn` is where its own middle lies, `arc` how far it goes
/// round, radians; it grows outward, `pitch` radians above the horizon.
MarginStart ring_start(Vec3 middle, double radius, double turn, double arc, double pitch, double edge);

/// A stalk that swells at its foot, with the past of its growth.
SheetBody stalk_body(double foot, double top, double height, Seed seed);

/// Adds a body to another.
void append(SheetBody& to, const SheetBody& more);

/// The fault of triangles longer than one of `parts` of the width.
Errors check_edge(double edge, double across, double parts);

/// So much skin of a sheet with such triangles, both its sides.
SizeEstimate estimate_surface(double area, double edge);

/// Bytes that the past of a body takes, for each of its triangles.
inline constexpr double kPastTriangle = 250;

/// What a skin that grows by layers takes, as estimated from the m2 that it comes to.
SizeEstimate estimate_surface(const Accretion& law, double area);

/// The body of a sheet as a model.
Model model_of(SheetBody body, const Material& material);

}  // namespace frond
