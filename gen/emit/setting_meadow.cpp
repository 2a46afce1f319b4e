#include "emit/setting_parts.h"
#include "settings/meadow.h"

namespace frond {

namespace {

std::string sky_text(const Scene& scene, double time) {
  const auto& meadow = scene.stage.block<Meadow>();
  return "Meadow_Globals()\nMeadow_Setting(" + eye_text(scene, time) + "," + color_text(meadow.zenith) + "," +
         color_text(meadow.horizon) + "," + color_text(meadow.grass) + "," + direction_text(meadow.sun) +
         "," + number_text(meadow.haze) + "," + number_text(meadow.clouds) + ")";
}

}  // namespace

SettingText meadow_text() {
  return {{"meadow"}, sky_text, [](const PovSpace& space, const Scene& scene) {
            return lawn_text(space, scene, scene.stage.block<Meadow>().grass, {});
          }};
}

}  // namespace frond
