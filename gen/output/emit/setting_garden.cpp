#include <algorithm>

#include "emit/setting_parts.h"
#include "settings/garden.h"
#include "settings/settings.h"

namespace frond {

namespace {

std::string sky_and_pond_text(const Scene& scene, double time) {
  SceneSetup setup = setup_at(scene.setup, time);
  const auto& garden = setup.block<Garden>();
  std::string text = globals_text("Meadow") +
                     country_text(garden_sky(setup), setup.block<Meadow>(), drawn_daylight(setup).fog);
  const PondShape& pond = garden.pond;
  bool ground = scene.film.background != Background::transparent;
  if (ground && pond.size.x > 0 && pond.size.y > 0)
    append_call(text += '\n', "Garden_Water", direction_text(Vec3(pond.center.x, pond.level, pond.center.y)),
                1.35 * std::max(pond.size.x, pond.size.y));
  return text;
}

}  // namespace

SettingText garden_text() {
  return {.includes = {"meadow", "garden"},
          .surroundings = sky_and_pond_text,
          .ground =
              [](const PovSpace& space, const Scene& scene) {
                return lawn_text(space, scene, scene.setup.block<Meadow>().grass,
                                 scene.setup.block<Garden>().gravel_color,
                                 scene.setup.block<Garden>().earth_color);
              },
          .sky = true};
}

}  // namespace frond
