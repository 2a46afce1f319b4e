#include <cmath>

#include "emit/setting_parts.h"
#include "settings/settings.h"
#include "settings/studio.h"

namespace frond {

namespace {

std::string room_text(const Scene& scene, double time) {
  const auto& studio = scene.stage.block<Studio>();
  double stops = scene.stage.camera.stops();
  std::string exposed =
      stops != 0 ? "#declare Studio_Exposure = " + number_text(std::exp2(stops)) + ";\n" : "";
  return exposed + "Studio_Globals()\nStudio_Setting(" + eye_text(scene, time) + "," +
         look_text(scene, time) + "," + color_text(studio.wall) + "," + number_text(studio.distance) + "," +
         direction_text(studio.key) + "," + light_text(drawn_daylight(scene.stage).sunlight) + "," +
         number_text(studio.softness) + ")";
}

}  // namespace

SettingText studio_text() {
  // The floor is one with the wall.
  return {{"studio"}, room_text, [](const PovSpace&, const Scene&) { return std::string(); }};
}

}  // namespace frond
