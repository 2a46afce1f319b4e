#include "cli/imported_preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "cli/messages.h"
#include "core/files.h"
#include "preset/json.h"
#include "scene/preset.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr double kLongest = 1;  ///< metres, the longest side of what is imported
constexpr double kAngle = 32;   ///< degrees, what the camera sees across

/// Four digits of a number.
Value figure(double x) {
  std::string text = fmt::format("{:.4g}", x);
  std::from_chars(text.data(), text.data() + text.size(), x);
  return make_number(x);
}
Value place(DVec3 v) { return make_list({figure(v.x), figure(v.y), figure(v.z)}); }

/// How far from the middle of a box an eye on a side of it sees the whole box with a rim of a tenth.
double distance_to_see(DVec3 size, DVec3 side) {
  DVec3 upward = side.y > 0.999 ? DVec3{0, 0, -1} : DVec3{0, 1, 0};
  DVec3 right = glm::normalize(glm::cross(upward, side)), up = glm::cross(side, right);
  double slope = 0.9 * std::tan(radians(kAngle / 2)), distance = 0;
  const Bounds box{Vec3(-0.5 * size), Vec3(0.5 * size)};
  for (int corner = 0; corner < 8; ++corner) {
    DVec3 at(box.corner(corner));
    double across = std::max(std::abs(glm::dot(at, right)), std::abs(glm::dot(at, up)));
    distance = std::max(distance, glm::dot(at, side) + across / slope);
  }
  return distance;
}

Value scene_of(DVec3 size, DVec3 side) {
  side = glm::normalize(side);
  side.y = std::max(side.y, 0.04);  // from below the floor nothing is seen
  side = glm::normalize(side);
  DVec3 middle{0, size.y / 2, 0};
  DVec3 eye = middle + side * distance_to_see(size, side);
  eye.y = std::max(eye.y, 0.05);
  Value camera = make_object(), studio = make_object(), scene = make_object();
  camera.set("location", place(eye)).set("look_at", place(middle)).set("angle", make_number(kAngle));
  studio.set("wall", make_text("#dfe3e0")).set("distance", figure(1.2 + size.z));
  return scene.set("setting", make_text("studio")).set("camera", camera).set("studio", studio);
}

}  // namespace

std::string preset_path(const ImportArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return fs::path(arguments.path).replace_extension(".json").string();
}

void write_imported(const ImportArguments& arguments, const ImportedPlant& plant) {
  DVec3 size(plant.box.size());
  if (plant.box.empty() || !(glm::length(size) > 0))
    fail({{arguments.path, "its turtle draws nothing; does it need more steps? --steps sets them"}},
         kWrongInput);
  if (!plant.measured) size *= kLongest / std::max({size.x, size.y, size.z});
  Value title = make_text(fs::path(arguments.path).stem().string());
  Value film = make_object(), stand = make_object(), one = make_object(), preset = make_object();
  film.set("frames", make_number(1)).set("size", make_list({make_number(640), make_number(640)}));
  Value middle = make_list({make_number(0), make_number(0)});
  stand.set("at", make_list({middle})).set("lean", make_number(0));
  stand.set("size_variation", make_number(0)).set("turn_variation", make_number(0));
  one.set("kind", make_text("plant")).set("name", title).set("place", stand);
  one.set("height", plant.measured ? make_number(0) : figure(size.y))
      .set("stand", make_text("middle"))
      .set("smoothing", make_number(1));
  one.set("thickness", make_object({{"least", {}, make_number(0.0002)}})).set("grammar", plant.grammar);
  for (const Member& look : plant.looks.members) one.set(look.name, look.value);
  preset.set("title", title)
      .set("version", make_number(kPresetVersion))
      .set("film", film.set("quality", make_text("good")));
  preset.set("scene", scene_of(size, plant.side)).set("organisms", make_list({one}));
  or_fail(write_file(preset_path(arguments), serialize_pretty(preset)), kCouldNot);
}

}  // namespace frond
