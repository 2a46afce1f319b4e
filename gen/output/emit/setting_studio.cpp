#include "emit/setting_parts.h"
#include "settings/settings.h"
#include "settings/studio.h"

namespace frond {

namespace {

std::string room_text(const Scene& scene, double time) {
  const auto& studio = scene.setup.block<Studio>();
  Daylight light = drawn_daylight(scene.setup);
  std::string view = eye_text(scene, time) + "," + look_text(scene, time);
  std::string text = "Studio_Globals()\n";
  append_call(text, "Studio_Room", view, studio.wall, studio.distance,
              light_text(light.backdrop.front().light));
  for (const Lamp& lamp : light.lamps) {
    std::string from;
    append_vector(from, 6, lamp.from.x, lamp.from.y, -lamp.from.z);
    append_call(text += '\n', "Studio_Lamp", view, from, light_text(lamp.light), lamp.width,
                static_cast<int>(lamp.shadows));
  }
  return text;
}

}  // namespace

SettingText studio_text() {
  // The floor is one with the wall.
  return {{"studio"}, room_text, [](const PovSpace&, const Scene&) { return std::string(); }};
}

}  // namespace frond
