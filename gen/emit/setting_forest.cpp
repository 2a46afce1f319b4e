#include "emit/setting_parts.h"
#include "settings/forest.h"

namespace frond {

namespace {

/// Under trees one opens the lens wider.
Daytime sky_of(const Scene& scene) {
  const auto& forest = scene.stage.block<Forest>();
  double clouds = scene.stage.block<Meadow>().clouds;
  Daytime day = daytime(sun_at(forest.hour, forest.south));
  day.sunlight *= 1.7f * static_cast<float>(1 - 0.45 * clouds * clouds);
  return day;
}

std::string wood_text(const Scene& scene, double time) {
  const auto& forest = scene.stage.block<Forest>();
  const auto& sky = scene.stage.block<Meadow>();
  Daytime day = sky_of(scene);
  return "Meadow_Globals()\nForest_Setting(" + eye_text(scene, time) + "," + sky_text(day) + "," +
         sun_text(day) + "," + number_text(sky.haze) + "," + number_text(sky.clouds) + "," +
         number_text(forest.mist) + "," +
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

Ambience wood_light(const Scene& scene, double) {
  Daytime day = sky_of(scene);
  day.zenith *= 2.2f;
  day.horizon *= 2.2f;
  return ambience(day, scene.stage.block<Forest>().litter);
}

}  // namespace

SettingText forest_text() { return {{"meadow", "forest"}, wood_text, forest_floor_text, wood_light}; }

}  // namespace frond
