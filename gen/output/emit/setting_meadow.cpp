#include "emit/setting_parts.h"
#include "settings/meadow.h"
#include "settings/settings.h"

namespace frond {

namespace {

/// A mountain far off shows the light that comes to it: no lamp of the scene reaches it.
std::string mountain_text(const PovSpace& space, const SceneSetup& setup) {
  const auto& meadow = setup.block<Meadow>();
  if (!meadow.mountain) return {};
  Sky sky = meadow_sky(setup);
  std::string text = "object{\n";
  append_mesh(text, space, mountain_surface(*meadow.mountain, sky.lamp));
  append_call(text += "\ntexture{", "Meadow_Rock", meadow.mountain->rock, meadow.grass, lamp_text(sky),
              air_text(sky));
  append_call(text += "}texture{", "Meadow_Veil", air_text(sky), meadow.haze);
  return text + "}no_shadow no_reflection no_radiosity}\n";
}

std::string summer_text(const Scene& scene, double time) {
  SceneSetup setup = setup_at(scene.setup, time);
  std::string text = globals_text("Meadow") +
                     country_text(meadow_sky(setup), setup.block<Meadow>(), drawn_daylight(setup).fog);
  return sun_moves(scene.setup) && !scene.film.transparent() ? text + "\n" + mountain_text({}, setup) : text;
}

}  // namespace

SettingText meadow_text() {
  return {.includes = {"meadow"},
          .surroundings = summer_text,
          .ground =
              [](const PovSpace& space, const Scene& scene) {
                return lawn_text(space, scene, scene.setup.block<Meadow>().grass, {}, {}) +
                       (sun_moves(scene.setup) || scene.film.transparent()
                            ? ""
                            : mountain_text(space, scene.setup));
              },
          .sky = true};
}

}  // namespace frond
