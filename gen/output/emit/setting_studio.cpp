#include "emit/setting_parts.h"
#include "settings/settings.h"
#include "settings/studio.h"

namespace frond {

namespace {

std::string room_text(const Scene& scene, double time) {
  const auto& studio = scene.setup.block<Studio>();
  Daylight light = drawn_daylight(scene.setup);
  std::string view = eye_text(scene, time) + "," + look_text(scene, time) + ",";
  std::string text = "Studio_Globals()\nStudio_Room(" + view + color_text(studio.wall) + "," +
                     number_text(studio.distance) + "," + light_text(light.backdrop.front().light) + ")";
  for (const Lamp& lamp : light.lamps) {
    text += "\nStudio_Lamp(" + view + '<';
    append_list(text, 6, lamp.from.x, lamp.from.y, -lamp.from.z);
    text += ">," + light_text(lamp.light) + "," + number_text(lamp.width) + ",";
    append_integer(text, static_cast<int>(lamp.shadows));
    text += ')';
  }
  return text;
}

}  // namespace

SettingText studio_text() {
  // The floor is one with the wall.
  return {{"studio"}, room_text, [](const PovSpace&, const Scene&) { return std::string(); }};
}

}  // namespace frond
