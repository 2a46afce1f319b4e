#include "emit/setting_parts.h"
#include "settings/forest.h"
#include "settings/settings.h"

namespace frond {

namespace {

/// The water of a stream at the time of the frame; nothing where there is none.
std::string water_text(const StreamCourse& stream) {
  if (!stream.flows()) return {};
  return "#declare Stream_Now = texture{Forest_Water(" + number_text(stream.speed()) + ")}\n";
}

std::string wood_text(const Scene& scene, double time) {
  SceneSetup setup = setup_at(scene.setup, time);
  const auto& forest = setup.block<Forest>();
  const auto& meadow = setup.block<Meadow>();
  Sky sky = forest_sky(setup);
  Daylight light = drawn_daylight(setup);
  const auto& ground = ground_as<ForestGround>(*scene.ground);
  return globals_text("Meadow") + sky_text(sky, meadow.clouds) + water_text(ground.stream()) +
         call_text("Forest_Setting", eye_text(scene, time), lamp_text(sky), light.fog, light.fade, light.mist,
                   forest.mist, ground.valley);
}

std::string forest_floor_text(const PovSpace& space, const Scene& scene) {
  const auto& ground = ground_as<ForestGround>(*scene.ground);
  const ForestCover& cover = ground.cover;
  std::string litter =
      scene.setup.year ? std::string(kYearLitter) : color_text(scene.setup.block<Forest>().litter);
  std::string wet = weather_over(false, is_rainy(scene.setup), Wetting::leaf);
  std::string green = color_text(scene.setup.block<Forest>().green);
  std::string_view macro = ground.mountain ? "Forest_Mountain(" : "Forest_Ground(";
  std::string text = floor_text(space, scene, std::string(macro) + litter + "," + green + ")");
  if (ground.stream().flows()) {
    append_mesh(text, space, ground.bed());
    text.insert(text.rfind('}'), "texture{Forest_Bed(" + litter + ")}");
    append_mesh(text, space, ground.water());
    text.insert(text.rfind('}'), "texture{Stream_Now} interior{ior 1.33} hollow no_shadow");
    text += "\n";
  }
  append_shapes(text, space, cover.litter, "Litter");
  append_shapes(text, space, cover.moss, "Moss");
  append_patches(text, space, cover.litter_patches, "Litter", "texture{Forest_Litter(" + litter + ")}" + wet);
  append_patches(text, space, cover.moss_patches, "Moss", "texture{Forest_Moss(" + green + ")}" + wet);
  return text;
}

}  // namespace

SettingText forest_text() {
  return {
      .includes = {"meadow", "forest"}, .surroundings = wood_text, .ground = forest_floor_text, .sky = true};
}

}  // namespace frond
