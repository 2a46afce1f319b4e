#include "appearance/skin_colors.h"

#include "appearance/bleaching.h"
#include "core/linear.h"

namespace frond {

Vec3 tinted(const Color& color, const Tint& tint) { return shifted(linear(color), tint.course.at(0)); }

Skin skin_at(const Skin& skin, double time) {
  Skin now = skin;
  const ColorCourse& all = skin.tint.course;
  now.tint.course = {all.hue.at(time), all.saturation.at(time), all.value.at(time)};
  return now;
}

SkinColors old_skin(const Skin& skin) {
  return {tinted(skin.tint.base, skin.tint), tinted(skin.tint.secondary, skin.tint)};
}

SkinColors young_skin(const Skin& skin) {
  constexpr Vec3 kLime(1.00f, 0.93f, 0.85f);
  SkinColors old = old_skin(skin);
  auto young = static_cast<float>(skin.tint.young);
  switch (skin.kind) {
    case SkinKind::stony: {
      // The skeleton shines through tissue that is still thin, and its pits are shallow.
      Vec3 tip = 0.55f * old.tissue + 0.45f * static_cast<float>(skin.tint.course.value.at(0)) * kLime;
      Vec3 tissue = glm::mix(old.tissue, tip, 0.85f * young * young);
      return {tissue, glm::mix(old.pits, tissue, 0.5f * young)};
    }
    case SkinKind::fan:
      return {(1 + 0.35f * young) * old.tissue, old.pits};
    case SkinKind::soft:
      return {(1 + 0.25f * young) * old.tissue, old.pits};
  }
  return old;
}

SkinColors bleached_skin(const Skin& skin) {
  Vec3 pale = bleached_color(tinted(skin.tint.base, skin.tint));
  return {pale, 0.5f * (pale + linear(skin.tint.secondary))};
}

SkinColors dead_skin(const Skin& skin) {
  Vec3 dead = dead_color(tinted(skin.tint.base, skin.tint));
  return {dead, 0.4f * dead};
}

Vec3 young_cube(const Tint& tint) {
  auto pale = [&](float c) { return static_cast<float>(c + (0.96 - c) * 0.62 * tint.young); };
  return tinted({pale(tint.base.red), pale(tint.base.green), pale(tint.base.blue)}, tint);
}

}  // namespace frond
