#pragma once

#include "core/vec.h"

namespace frond {

/// What the skin of a coral turns to where neighbours take its light: bleached, so that its skeleton shows
/// through, then dead under a turf of algae. POV-Ray's macros are handed these numbers. Colours are linear.
struct Bleaching {
  /// Shares of its light, 0..1: up to the first it is dead, at the second bleached, from the third on as in
  /// the open.
  float dead_light = 0.28f, pale_light = 0.36f, living_light = 0.52f;
  Vec3 lime{0.92f, 0.88f, 0.80f};  ///< of the skeleton
  Vec3 turf{0.62f, 0.55f, 0.30f};  ///< of the algae
  float kept = 0.30f;              ///< share of its own colour that bleached skin keeps
  /// How much lime and turf show on skin that is black, and how much more for its grey.
  float lime_least = 0.30f, lime_by_gray = 0.75f, turf_least = 0.18f, turf_by_gray = 0.80f;
  float most_gray = 0.55f;  ///< the grey from which on these rise no more
};

inline constexpr Bleaching kBleaching;

/// Skin of a linear colour when it is bleached, and when it is dead.
Vec3 bleached_color(Vec3 color);
Vec3 dead_color(Vec3 color);

/// What skin of a linear colour shows with so much of its light left.
Vec3 starved_color(Vec3 color, float light);

}  // namespace frond
