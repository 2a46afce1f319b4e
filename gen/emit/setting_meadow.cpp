#include "emit/setting_parts.h"
#include "settings/meadow.h"

namespace frond {

namespace {

std::string summer_text(const Scene& scene, double) {
  const auto& meadow = scene.stage.block<Meadow>();
  return "Meadow_Globals()\n" + country_text(meadow_sky(scene.stage), meadow);
}

Ambience summer_light(const Scene& scene, double) {
  return ambience(meadow_sky(scene.stage), scene.stage.block<Meadow>().grass);
}

}  // namespace

SettingText meadow_text() {
  return {{"meadow"},
          summer_text,
          [](const PovSpace& space, const Scene& scene) {
            return lawn_text(space, scene, scene.stage.block<Meadow>().grass, {});
          },
          summer_light};
}

}  // namespace frond
