#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/frame_name.h"
#include "core/linear.h"
#include "core/text.h"
#include "emit/setting_parts.h"
#include "images/caustics.h"
#include "settings/settings.h"
#include "settings/underwater.h"

namespace frond {

namespace {

/// `frame_0012.caustics`, or between frames `frame_0012_250.caustics`
std::string caustics_name(const Scene& scene, double time) {
  long thousandths = std::lround(1000 * time * scene.film.fps), frame = thousandths / 1000 + 1;
  std::string name = frame_name(static_cast<int>(frame));
  if (thousandths % 1000 != 0) name += fmt::format("_{:03}", thousandths % 1000);
  return name + ".caustics";
}

Result<std::vector<Picture>> caustics(const Scene& scene, double time) {
  if (scene.setup.block<Water>().caustics <= 0) return std::vector<Picture>();
  auto quality = static_cast<int>(scene.film.quality);
  Raster picture = caustics_picture({.pixels = caustic_pixels(scene.film.quality),
                                     .focus = 0.27 + 0.04 * quality,
                                     .time = time,
                                     .loop = scene.film.length()});
  Result<std::string> bytes = png_text(picture);
  if (!bytes) return bytes.errors();
  return std::vector<Picture>{{caustics_name(scene, time), std::move(*bytes)}};
}

/// Its macros take metres, in POV-Ray's axes.
std::string water_text(const Scene& scene, double time) {
  const auto& water = scene.setup.block<Water>();
  std::string eye = eye_text(scene, time), look = look_text(scene, time);
  auto exposed = static_cast<float>(std::exp2(scene.setup.camera.stops()));
  std::string near = color_text(exposed == 1 ? water.near : seen_color(exposed * linear(water.near)));
  std::string sun = direction_text(water.sun);
  Daylight light = drawn_daylight(scene.setup);
  std::string text = globals_text("Water") + backdrop_text(light) + "Water_Setting(" + eye + "," +
                     light_text(light.fog) + "," + number_text(light.fade) + "," + sun + "," +
                     light_text(light.sunlight) + "," + number_text(water.caustics) + ",\"" +
                     caustics_name(scene, time) + "\")\n";
  if (scene.film.transparent()) return text;
  if (water.shafts > 0)
    text +=
        "Water_Shafts(" + eye + "," + look + "," + near + "," + sun + "," + number_text(water.shafts) + ")\n";
  if (water.particles > 0)
    text += "Water_Particles(" + eye + "," + look + "," + number_text(water.particles) + ")\n";
  return text + "Water_Surface(" + eye + "," + near + ")";
}

void append_stones(std::string& text, const PovSpace& space, const SeaFloor& floor) {
  for (std::size_t i = 0; i < floor.stones.size(); ++i) {
    append_name(text, "#declare Stone", i);
    text += " = ";
    append_mesh(text, space, floor.stones[i]);
    text += '\n';
  }
  for (const StoneInstance& stone : floor.stone_instances) {
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

constexpr std::string_view kSand = "Sand_Texture()";

std::string sea_floor_text(const PovSpace& space, const Scene& scene) {
  std::string text = floor_text(space, scene, kSand);
  append_stones(text, space, ground_as<SeaFloor>(*scene.ground));
  return text;
}

}  // namespace

SettingText underwater_text() {  // Food may drift there in any case.
  return {{"water", "sand", "coral", "food"}, water_text, sea_floor_text, caustics, kSand};
}

}  // namespace frond
