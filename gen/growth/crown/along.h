#pragma once

#include "core/curve.h"

// Curves along a parent, which say how what it bears changes from its foot (0) to its tip (1).
namespace frond {

/// The curve of what does not change.
inline Curve even_along() { return Curve({{0, 1}, {1, 1}}); }

/// Whether a curve is 1 everywhere.
bool is_even(const Curve& curve);

/// The factor at a place, never negative; exactly 1 where the curve is even.
double factor_along(const Curve& curve, double place);

/// The mean factor between two places.
double mean_along(const Curve& curve, double from, double to);

/// The place between two others below which lies that share of what a density distributes there, 0..1.
double place_by_density(const Curve& density, double from, double to, double share);

}  // namespace frond
