#pragma once

#include "appearance/skin.h"

// The colours of corals, linear, at brightness 1. Macros, exports and the studio's page take them from here.

namespace frond {

/// The colours of a skin: of its tissue, and in pits and grooves.
struct SkinColors {
  Vec3 tissue{0}, pits{0};
};

/// A colour with a coral's hue, saturation and value, those at the beginning of the film.
Vec3 tinted(const Color& color, const Tint& tint);

/// A skin whose hue, saturation and value are those of a time, in seconds, at all times.
Skin skin_at(const Skin& skin, double time);

/// The colours of old skin, and of skin at growing tips.
SkinColors old_skin(const Skin& skin);
SkinColors young_skin(const Skin& skin);

/// The colours of skin that neighbours shade: bleached, and dead.
SkinColors bleached_skin(const Skin& skin);
SkinColors dead_skin(const Skin& skin);

/// The colour of cubes at growing tips, which have no pits.
Vec3 young_cube(const Tint& tint);

}  // namespace frond
