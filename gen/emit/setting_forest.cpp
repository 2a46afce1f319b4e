#include "emit/setting_parts.h"
#include "settings/forest.h"

namespace frond {

namespace {

std::string wood_text(const Scene& scene, double time) {
  const auto& forest = scene.stage.block<Forest>();
  const auto& sky = scene.stage.block<Meadow>();
  return "Meadow_Globals()\nForest_Setting(" + eye_text(scene, time) + "," + color_text(forest.litter) + "," +
         direction_text(sun_at(forest.hour, forest.south)) + "," + number_text(sky.haze) + "," +
         number_text(sky.clouds) + "," + number_text(forest.mist) + "," +
         number_text(static_cast<const ForestGround&>(*scene.ground).valley) + ")";
}

std::string forest_floor_text(const PovSpace& space, const Scene& scene) {
  const ForestCover& cover = static_cast<const ForestGround&>(*scene.ground).cover;
  std::string litter = color_text(scene.stage.block<Forest>().litter);
  std::string text = floor_text(space, scene, "Forest_Ground(" + litter + ")");
  append_shapes(text, space, cover.litter, "Litter");
  append_shapes(text, space, cover.moss, "Moss");
  append_patches(text, space, cover.litter_patches, "Litter", "texture{Forest_Litter(" + litter + ")}");
  append_patches(text, space, cover.moss_patches, "Moss", "texture{Forest_Moss()}");
  return text;
}

}  // namespace

SettingText forest_text() { return {{"meadow", "garden", "forest"}, wood_text, forest_floor_text}; }

}  // namespace frond
