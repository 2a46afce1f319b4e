#include "scene/colony_state.h"

#include "appearance/bleaching.h"
#include "core/linear.h"

namespace frond {

namespace {

Color color_in(const Color& color, ColonyState state) {
  switch (state) {
    case ColonyState::living:
      return color;
    case ColonyState::bleached:
      return srgb(bleached_color(linear(color)));
    case ColonyState::dead:
      return srgb(dead_color(linear(color)));
  }
  return color;
}

}  // namespace

Skin skin_in(const Skin& skin, ColonyState state) {
  if (state == ColonyState::living) return skin;
  Skin bare = skin;
  // The tint's own factors are of the tissue.
  bare.tint.base = color_in(skin.tint.base, state),
  bare.tint.secondary = color_in(skin.tint.secondary, state);
  bare.tint.course = {}, bare.tint.young = 0;
  bare.polyps.width = bare.polyps.glow = 0;
  return bare;
}

Material material_in(const Material& material, ColonyState state) {
  if (!is_tissue(material.matter)) return material;
  Material bare = material;
  bare.color = color_in(material.color, state), bare.second = color_in(material.second, state);
  if (state != ColonyState::living) bare.polyps.width = bare.polyps.glow = 0, bare.gloss = 0;
  if (state == ColonyState::dead) bare.dead.clear();
  return bare;
}

}  // namespace frond
