#include "emit/setting.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/text.h"
#include "emit/solid.h"

namespace frond {

namespace {

std::string number(double value) {
  std::string text;
  append(text, value, 5);
  return text;
}

std::string direction(Vec3 v) {
  std::string text;
  append_direction(text, v);
  return text;
}

std::string color(const Color& c) {
  std::string text;
  append_color(text, c);
  return text;
}

/// The water as the camera sees it at one time. Its macros take metres, in POV-Ray's axes.
std::string water_text(const Stage& stage, double time) {
  const Water& water = stage.water;
  std::string eye = direction(stage.camera.location.at(time)),
              look = direction(stage.camera.look_at.at(time));
  std::string near = color(water.near), sun = direction(water.sun);
  std::string text = "Water_Globals()\nWater_Setting(" + eye + "," + near + "," + color(water.deep) + "," +
                     number(water.visibility) + "," + sun + "," + number(water.caustics) + ")\n";
  if (water.shafts > 0)
    text += "Water_Shafts(" + eye + "," + look + "," + near + "," + sun + "," + number(water.shafts) + ")\n";
  if (water.particles > 0)
    text += "Water_Particles(" + eye + "," + look + "," + number(water.particles) + ")\n";
  return text + "Water_Surface(" + eye + "," + near + ")";
}

std::string studio_text(const Stage& stage, double time) {
  const Studio& studio = stage.studio;
  return "Studio_Globals()\nStudio_Setting(" + direction(stage.camera.location.at(time)) + "," +
         direction(stage.camera.look_at.at(time)) + "," + color(studio.wall) + "," + number(studio.distance) +
         "," + direction(studio.key) + "," + number(studio.softness) + ")";
}

std::string meadow_text(const Stage& stage, double time) {
  const Meadow& meadow = stage.meadow;
  return "Meadow_Globals()\nMeadow_Setting(" + direction(stage.camera.location.at(time)) + "," +
         color(meadow.zenith) + "," + color(meadow.horizon) + "," + color(meadow.grass) + "," +
         direction(meadow.sun) + "," + number(meadow.haze) + "," + number(meadow.clouds) + ")";
}

/// Toward the sun at an hour: it rises at about 5, stands highest at 13 and sets at about 21, as in June at
/// 50 degrees of latitude; below the horizon at night.
Vec3 sun_at(double hour, double south) {
  double day = kPi * (hour - 13) / 12, latitude = radians(50.0), tilt = radians(23.4);
  double up = std::sin(latitude) * std::sin(tilt) + std::cos(latitude) * std::cos(tilt) * std::cos(day);
  double west = std::cos(tilt) * std::sin(day);
  double noon = std::cos(tilt) * std::cos(day) * std::sin(latitude) - std::sin(tilt) * std::cos(latitude);
  double c = std::cos(south), s = std::sin(south);
  return Vec3(noon * s - west * c, up, noon * c + west * s);
}

std::string garden_text(const Stage& stage, double time) {
  const Garden& garden = stage.garden;
  const Meadow& lawn = stage.meadow;
  Vec3 sun = sun_at(garden.hour, garden.south);
  std::string text = "Meadow_Globals()\nGarden_Setting(" + direction(stage.camera.location.at(time)) + "," +
                     color(lawn.grass) + "," + direction(sun) + "," + number(lawn.haze) + "," +
                     number(lawn.clouds) + ")";
  const PondShape& pond = garden.pond;
  if (pond.size.x > 0 && pond.size.y > 0)
    text += "\nGarden_Water(" + direction(Vec3(pond.center.x, pond.level, pond.center.y)) + "," +
            number(1.35 * std::max(pond.size.x, pond.size.y)) + ")";
  return text;
}

std::string forest_text(const Scene& scene, double time) {
  const Stage& stage = scene.stage;
  const Forest& forest = stage.forest;
  auto half = static_cast<float>(forest.terrain.size / 2);
  float valley = 0;
  for (const Vec3& p : scene.floor.position)
    if (std::max(std::abs(p.x), std::abs(p.z)) <= half) valley = std::min(valley, p.y);
  return "Meadow_Globals()\nForest_Setting(" + direction(stage.camera.location.at(time)) + "," +
         color(forest.litter) + "," + direction(sun_at(forest.hour, forest.south)) + "," +
         number(stage.meadow.haze) + "," + number(stage.meadow.clouds) + "," + number(forest.mist) + "," +
         number(valley) + ")";
}

void append_name(std::string& text, std::string_view name, std::size_t index) {
  text += name;
  append_integer(text, static_cast<long long>(index));
}

void append_stones(std::string& text, const PovSpace& space, const Scene& scene) {
  for (std::size_t i = 0; i < scene.stones.size(); ++i) {
    append_name(text, "#declare Stone", i);
    text += " = ";
    append_mesh(text, space, scene.stones[i]);
    text += '\n';
  }
  for (const StoneInstance& stone : scene.stone_instances) {
    append_name(text, "object{Stone", static_cast<std::size_t>(stone.shape));
    text += " scale<";
    append_list(text, 5, stone.size.x, stone.size.y, stone.size.z);
    text += ">rotate y*";
    append(text, -degrees(stone.turn),
           3);  // the mirror turns the other way round, and so do left-handed turns
    text += " translate";
    append_point(text, space, stone.at);
    text += " texture{Rock_Texture(";
    append_integer(text, stone.look);
    text += ")}}\n";
  }
}

void append_shapes(std::string& text, const PovSpace& space, const std::vector<Surface>& shapes,
                   std::string_view name) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    append_name(text, "#declare " + std::string(name), i);
    text += " = ";
    append_mesh(text, space, shapes[i]);
    text += "\n";
  }
}

/// One union of all patches of a kind, such as "Turf", "Bloom" or "Gravel", with the texture on it.
void append_patches(std::string& text, const PovSpace& space, const Scene& scene,
                    const std::vector<TurfInstance>& patches, std::string_view name,
                    std::string_view texture) {
  std::size_t start = text.size();
  text += "union{\n";
  std::size_t empty = text.size();
  for (const TurfInstance& patch : patches) {
    auto shape = static_cast<std::size_t>(patch.shape);
    if (name == "Bloom" && scene.turf[shape].flowers.triangle.empty()) continue;
    text += "object{";
    append_name(text, name, shape);
    text += ' ';
    // Turned, then sheared along the slope of the ground.
    float c = static_cast<float>(std::cos(patch.turn)), s = static_cast<float>(std::sin(patch.turn));
    glm::mat3 turn(c, patch.slope.x * c + patch.slope.y * s, s, 0, 1, 0, -s,
                   -patch.slope.x * s + patch.slope.y * c, c);
    append_matrix(text, space, turn, patch.at);
    text += "}\n";
  }
  if (text.size() == empty) return text.resize(start);
  text += texture;
  text += "}\n";
}

void append_turf(std::string& text, const PovSpace& space, const Scene& scene) {
  if (scene.turf_instances.empty()) return;
  bool blooms = false;
  for (std::size_t i = 0; i < scene.turf.size(); ++i) {
    append_name(text, "#declare Turf", i);
    text += " = ";
    append_mesh(text, space, scene.turf[i].blades);
    text += "\n";
    if (scene.turf[i].flowers.triangle.empty()) continue;
    blooms = true;
    append_name(text, "#declare Bloom", i);
    text += " = ";
    append_mesh(text, space, scene.turf[i].flowers);
    text += "\n";
  }
  append_patches(text, space, scene, scene.turf_instances, "Turf",
                 "texture{Meadow_Blade(" + color(scene.stage.meadow.grass) + ")}");
  if (blooms) append_patches(text, space, scene, scene.turf_instances, "Bloom", "texture{Meadow_Bloom()}");
}

void append_gravel(std::string& text, const PovSpace& space, const Scene& scene) {
  if (scene.gravel_instances.empty()) return;
  append_shapes(text, space, scene.gravel, "Gravel");
  append_patches(text, space, scene, scene.gravel_instances, "Gravel",
                 "texture{Garden_Gravel(" + color(scene.stage.garden.gravel_color) + ")}");
}

void append_litter(std::string& text, const PovSpace& space, const Scene& scene) {
  append_shapes(text, space, scene.litter, "Litter");
  append_shapes(text, space, scene.moss, "Moss");
  std::string litter = color(scene.stage.forest.litter);
  append_patches(text, space, scene, scene.litter_instances, "Litter",
                 "texture{Forest_Litter(" + litter + ")}");
  append_patches(text, space, scene, scene.moss_instances, "Moss", "texture{Forest_Moss()}");
}

}  // namespace

std::string includes_text(const Scene& scene) {
  bool plants = std::any_of(scene.branches.begin(), scene.branches.end(),
                            [](const Branches& b) { return b.bark.has_value(); });
  bool corals = std::any_of(scene.branches.begin(), scene.branches.end(),
                            [](const Branches& b) { return b.skin.has_value(); });
  bool water = scene.stage.setting == Setting::underwater;
  std::string text;
  auto include = [&](std::string_view name) {
    if (!text.empty()) text += '\n';
    text += "#include \"frond_" + std::string(name) + ".inc\"";
  };
  switch (scene.stage.setting) {
    case Setting::underwater:
      include("water"), include("sand");
      break;
    case Setting::studio:
      include("studio");
      break;
    case Setting::meadow:
      include("meadow");
      break;
    case Setting::garden:
      include("meadow"), include("garden");
      break;
    case Setting::forest:
      include("meadow"), include("garden"), include("forest");
      break;
  }
  if (water || corals) include("coral"), include("food");
  if (plants) include("plant");
  if (!scene.drawings.empty()) include("tree");
  if (std::any_of(scene.branches.begin(), scene.branches.end(),
                  [](const Branches& b) { return b.style.build == Build::voxels; }))
    include("voxel");
  if (std::any_of(scene.branches.begin(), scene.branches.end(),
                  [](const Branches& b) { return b.creeper.has_value(); }))
    include("ivy");
  for (std::string_view name : solid_includes(scene)) include(name);
  return text;
}

std::string setting_text(const Scene& scene, double time) {
  const Stage& stage = scene.stage;
  switch (stage.setting) {
    case Setting::underwater:
      return water_text(stage, time);
    case Setting::studio:
      return studio_text(stage, time);
    case Setting::meadow:
      return meadow_text(stage, time);
    case Setting::garden:
      return garden_text(stage, time);
    case Setting::forest:
      return forest_text(scene, time);
  }
  return {};
}

std::string ground_text(const PovSpace& space, const Scene& scene) {
  std::string text;
  if (scene.stage.setting == Setting::studio) return text;  // its floor is one with the wall
  text = "object{\n";
  append_mesh(text, space, scene.floor);
  if (scene.stage.setting == Setting::underwater) {
    text += "\ntexture{Sand_Texture()}}\n";
    append_stones(text, space, scene);
  } else if (scene.stage.setting == Setting::forest) {
    text += "\ntexture{Forest_Ground(" + color(scene.stage.forest.litter) + ")}}\n";
    append_litter(text, space, scene);
  } else {
    text += "\ntexture{Meadow_Ground(" + color(scene.stage.meadow.grass) + ")}}\n";
    append_turf(text, space, scene);
    append_gravel(text, space, scene);
  }
  return text;
}

}  // namespace frond
