#pragma once

#include <span>

#include "settings/setting.h"

namespace frond {

/// All settings, one row each. Row `x` is settings/x.cpp, which defines `SettingRow x_setting()`, and
/// emit/setting_x.cpp.
#define FROND_SETTINGS(row) row(underwater) row(studio) row(meadow) row(garden) row(forest)

#define FROND_DECLARE(name) SettingRow name##_setting();
FROND_SETTINGS(FROND_DECLARE)
#undef FROND_DECLARE

/// Their table.
std::span<const SettingRow> settings();
/// Adds what a setting's block tells.
void describe_rest(KeyWriter& v, std::any& block);
/// Index of the row of that name; the number of rows if there is none.
std::size_t row_of(std::string_view name);

/// Whether the light of the sky changes over the film, by the hour of the day, by rain or by snowfall.
bool sun_moves(const SceneSetup& setup);
/// The setup with the hour, the snow and the rain of that time, seconds, as if they never changed; without it
/// the film's beginning counts.
SceneSetup setup_at(const SceneSetup& setup, double time);

/// Whether there is snow or hoarfrost at some time.
bool is_snowy(const SceneSetup& setup);
/// Share of the land that snow whitens at the beginning of the film, 0..1.
double snow_cover(const SceneSetup& setup);

/// Whether it rains or is wet at some time.
bool is_rainy(const SceneSetup& setup);
/// Whether there is air that scatters light.
bool is_misty(const SceneSetup& setup);
/// Share of the sky that clouds of rain or snow take at the beginning of the film, 0..1.
double overcast(const SceneSetup& setup);
/// How wet things in the open are at the beginning of the film, 0..1.
double wet_share(const SceneSetup& setup);

/// The direction x, z of slopes that see least of the sun at noon, shorter than 1 where it stands high.
Vec2 shaded_side(SceneSetup setup);

/// The lighting of a scene as POV-Ray draws it, and as its finished picture shows it.
Daylight drawn_daylight(const SceneSetup& setup);
Daylight daylight_of(SceneSetup setup);

}  // namespace frond
