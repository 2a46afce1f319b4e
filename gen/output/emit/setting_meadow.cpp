#include "emit/setting_parts.h"
#include "settings/meadow.h"
#include "settings/settings.h"

namespace frond {

namespace {

/// A mountain far off shows the light that comes to it: no lamp of the scene reaches it.
std::string mountain_text(const PovSpace& space, const Stage& stage) {
  const auto& meadow = stage.block<Meadow>();
  if (!meadow.mountain) return {};
  Sky sky = meadow_sky(stage);
  std::string text = "object{\n";
  append_mesh(text, space, mountain_surface(*meadow.mountain, sky.lamp));
  text += "\ntexture{Meadow_Rock(" + color_text(meadow.mountain->rock) + "," + color_text(meadow.grass) +
          "," + lamp_text(sky) + "," + air_text(sky) + ")}";
  return text + "texture{Meadow_Veil(" + air_text(sky) + "," + number_text(meadow.haze) +
         ")}no_shadow no_reflection no_radiosity}\n";
}

std::string summer_text(const Scene& scene, double time) {
  Stage stage = stage_at(scene.stage, time);
  std::string text = globals_text("Meadow") +
                     country_text(meadow_sky(stage), stage.block<Meadow>(), drawn_daylight(stage).fog);
  return sun_moves(scene.stage) && !scene.film.transparent() ? text + "\n" + mountain_text({}, stage) : text;
}

}  // namespace

SettingText meadow_text() {
  return {.includes = {"meadow"},
          .surroundings = summer_text,
          .ground =
              [](const PovSpace& space, const Scene& scene) {
                return lawn_text(space, scene, scene.stage.block<Meadow>().grass, {}, {}) +
                       (sun_moves(scene.stage) || scene.film.transparent()
                            ? ""
                            : mountain_text(space, scene.stage));
              },
          .sky = true};
}

}  // namespace frond
