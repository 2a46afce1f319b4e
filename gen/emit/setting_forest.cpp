#include "emit/setting_parts.h"
#include "settings/forest.h"
#include "settings/settings.h"

namespace frond {

namespace {

/// The water of a stream at the time of the frame.
std::string water_text(const Scene& scene) {
  return "#declare Stream_Now = texture{Forest_Water(" +
         number_text(ground_as<ForestGround>(*scene.ground).stream().speed()) + ")}\n";
}

std::string wood_text(const Scene& scene, double time) {
  Stage stage = stage_at(scene.stage, time);
  const auto& forest = stage.block<Forest>();
  const auto& meadow = stage.block<Meadow>();
  Sky sky = forest_sky(stage);
  Daylight light = drawn_daylight(stage);
  return globals_text("Meadow") + sky_text(sky, meadow.clouds) + "" +
         (ground_as<ForestGround>(*scene.ground).stream().flows() ? water_text(scene) : "") +
         "Forest_Setting(" + eye_text(scene, time) + "," + lamp_text(sky) + "," + vector_text(light.fog) +
         "," + number_text(light.fade) + "," + vector_text(light.mist) + "," + number_text(forest.mist) +
         "," + number_text(ground_as<ForestGround>(*scene.ground).valley) + ")";
}

std::string forest_floor_text(const PovSpace& space, const Scene& scene) {
  const ForestCover& cover = ground_as<ForestGround>(*scene.ground).cover;
  std::string litter =
      scene.stage.year ? std::string(kYearLitter) : color_text(scene.stage.block<Forest>().litter);
  std::string wet = weather_over(false, is_rainy(scene.stage), Wetting::leaf);
  std::string green = color_text(scene.stage.block<Forest>().green);
  std::string text = floor_text(space, scene, "Forest_Ground(" + litter + "," + green + ")");
  const auto& ground = ground_as<ForestGround>(*scene.ground);
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

SettingText forest_text() { return {{"meadow", "forest"}, wood_text, forest_floor_text}; }

}  // namespace frond
