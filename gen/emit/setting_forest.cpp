#include "emit/setting_parts.h"
#include "settings/forest.h"
#include "settings/settings.h"

namespace frond {

namespace {

std::string wood_text(const Scene& scene, double time) {
  Stage stage = stage_at(scene.stage, time);
  const auto& forest = stage.block<Forest>();
  const auto& meadow = stage.block<Meadow>();
  Sky sky = forest_sky(stage);
  Daylight light = drawn_daylight(stage);
  return globals_text("Meadow") + sky_text(sky, meadow.clouds) + "Forest_Setting(" + eye_text(scene, time) +
         "," + lamp_text(sky) + "," + vector_text(light.fog) + "," + number_text(light.fade) + "," +
         vector_text(light.mist) + "," + number_text(forest.mist) + "," +
         number_text(ground_as<ForestGround>(*scene.ground).valley) + ")";
}

std::string forest_floor_text(const PovSpace& space, const Scene& scene) {
  const ForestCover& cover = ground_as<ForestGround>(*scene.ground).cover;
  std::string litter =
      scene.stage.year ? std::string(kYearLitter) : color_text(scene.stage.block<Forest>().litter);
  std::string wet = weather_over(false, is_rainy(scene.stage), Wetting::leaf);
  std::string green = color_text(scene.stage.block<Forest>().green);
  std::string text = floor_text(space, scene, "Forest_Ground(" + litter + "," + green + ")");
  append_shapes(text, space, cover.litter, "Litter");
  append_shapes(text, space, cover.moss, "Moss");
  append_patches(text, space, cover.litter_patches, "Litter", "texture{Forest_Litter(" + litter + ")}" + wet);
  append_patches(text, space, cover.moss_patches, "Moss", "texture{Forest_Moss(" + green + ")}" + wet);
  return text;
}

}  // namespace

SettingText forest_text() { return {{"meadow", "forest"}, wood_text, forest_floor_text}; }

}  // namespace frond
