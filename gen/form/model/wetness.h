#pragma once

#include <optional>

#include "core/vec.h"
#include "model/matter.h"

// What water does to the look of a surface.

namespace frond {

/// Share of light that a film of water mirrors, seen from above.
inline constexpr double kFilmMirrors = 0.02;

/// The factor of what a matt surface of an albedo throws back when it is wet: light is thrown back into it
/// again and again below the film (Angstrom 1925, Lekner and Dorf 1988):
/// (1 - r)(1 - p) / (1 - p A), with r = 0.02 mirrored outside, and p = 0.47 mirrored inside of water, whose
/// refraction is 1.33. Together with what the film mirrors a wet surface is darkest, as against a dry one, at
/// an albedo of about 0.27. Lekner and Dorf also let more light into the material, which is left out.
constexpr double wet_factor(double albedo) {
  constexpr double kInside = 0.472;
  return (1 - kFilmMirrors) * (1 - kInside) / (1 - kInside * albedo);
}

/// How surfaces take water.
enum class Wetting { soil, stone, wood, leaf, glaze };

struct WettingRow {
  const char* texture;  ///< as frames name it
  Vec3 albedo;          ///< linear, of the dry surface
  double porous;        ///< 0 water stays on it as drops .. 1 it is soaked
  double film;          ///< 0 the film follows what is rough .. 1 it is smooth; a mirror from 0.75 on
};

inline constexpr WettingRow kWettings[] = {{"Wet_Soil", {0.20f, 0.15f, 0.10f}, 1.0, 0.25},
                                           {"Wet_Stone", {0.30f, 0.29f, 0.27f}, 0.9, 0.8},
                                           {"Wet_Wood", {0.25f, 0.19f, 0.14f}, 0.9, 0.5},
                                           {"Wet_Leaf", {0.08f, 0.14f, 0.04f}, 0.25, 0.7},
                                           {"Wet_Glaze", {0.30f, 0.30f, 0.30f}, 0, 1.0}};

constexpr const WettingRow& row_of(Wetting wetting) { return kWettings[static_cast<std::size_t>(wetting)]; }

/// What a wet surface keeps of its colours, as a factor of each channel.
constexpr Vec3 wet_colors(const WettingRow& row) {
  Vec3 keep(1);
  for (int i = 0; i < 3; ++i)
    keep[i] = static_cast<float>(1 - row.porous * (1 - wet_factor(static_cast<double>(row.albedo[i]))));
  return keep;
}

/// How a material takes water; none: it is water or glass, or its own macro says it, below the moss on it.
constexpr std::optional<Wetting> wetting_of(Matter matter) {
  switch (matter) {
    case Matter::granite:
    case Matter::karst:
    case Matter::basalt:
    case Matter::snow:
    case Matter::water:
      return std::nullopt;
    case Matter::timber:
      return Wetting::wood;
    case Matter::soil:
      return Wetting::soil;
    case Matter::paint:
    case Matter::pane:
    case Matter::ceramic:
    case Matter::plain:
      return Wetting::glaze;
    default:
      return row_of(matter).inside.empty() ? std::optional(Wetting::stone) : std::nullopt;
  }
}

}  // namespace frond
