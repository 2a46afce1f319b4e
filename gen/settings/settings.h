#pragma once

#include <span>

#include "settings/setting.h"

namespace frond {

/// All settings, one row each. Row `x` stands for settings/x.cpp, which defines `SettingRow x_setting()`, and
/// for emit/setting_x.cpp.
#define FROND_SETTINGS(row) row(underwater) row(studio) row(meadow) row(garden) row(forest)

#define FROND_DECLARE(name) SettingRow name##_setting();
FROND_SETTINGS(FROND_DECLARE)
#undef FROND_DECLARE

/// The table of them.
std::span<const SettingRow> settings();
/// Which row a name is; as many as there are rows where it is none.
std::size_t row_of(std::string_view name);

/// What lights a stage as POV-Ray draws it, and as its finished picture shows it.
Daylight drawn_daylight(const Stage& stage);
Daylight daylight_of(Stage stage);

}  // namespace frond
