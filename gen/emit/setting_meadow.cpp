#include "core/linear.h"
#include "emit/setting_parts.h"
#include "settings/meadow.h"

namespace frond {

namespace {

Daytime sky_of(const Meadow& meadow) {
  Daytime day;
  day.sun = glm::normalize(meadow.sun);
  day.zenith = linear(meadow.zenith);
  day.horizon = linear(meadow.horizon);
  day.sunlight = Vec3(1, 0.93f, 0.78f) * 3.0f;
  return day;
}

std::string summer_text(const Scene& scene, double time) {
  const auto& meadow = scene.stage.block<Meadow>();
  Daytime day = sky_of(meadow);
  return "Meadow_Globals()\nMeadow_Setting(" + eye_text(scene, time) + "," + sky_text(day) + "," +
         color_text(meadow.grass) + "," + sun_text(day) + "," + number_text(meadow.haze) + "," +
         number_text(meadow.clouds) + ")";
}

Ambience summer_light(const Scene& scene, double) {
  const auto& meadow = scene.stage.block<Meadow>();
  return ambience(sky_of(meadow), meadow.grass);
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
