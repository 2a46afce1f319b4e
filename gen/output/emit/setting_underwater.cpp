#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/frame_name.h"
#include "core/linear.h"
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

std::string backdrop_text(const Daylight& light) {
  std::string text = fmt::format("#declare Water_Backdrop = array[{}]{{", light.backdrop.size());
  for (const BackdropStop& stop : light.backdrop) {
    if (text.back() != '{') text += ',';
    append_vector(text, 6, stop.light.r, stop.light.g, stop.light.b, stop.height);
  }
  return text + "};\n";
}

/// Its macros take metres, in POV-Ray's axes.
std::string water_text(const Scene& scene, double time) {
  const auto& water = scene.setup.block<Water>();
  std::string eye = eye_text(scene, time), look = look_text(scene, time);
  auto exposed = static_cast<float>(std::exp2(scene.setup.camera.stops()));
  std::string near = color_text(exposed == 1 ? water.near : seen_color(exposed * linear(water.near)));
  std::string sun = direction_text(water.sun);
  Daylight light = drawn_daylight(scene.setup);
  std::string text = globals_text("Water") + backdrop_text(light);
  append_call(text, "Water_Setting", eye, light_text(light.fog), light.fade, sun, light_text(light.sunlight),
              water.caustics, '"' + caustics_name(scene, time) + '"');
  text += '\n';
  if (scene.film.transparent()) return text;
  if (water.shafts > 0) text += call_text("Water_Shafts", eye, look, near, sun, water.shafts) + '\n';
  if (water.particles > 0) text += call_text("Water_Particles", eye, look, water.particles) + '\n';
  return text + call_text("Water_Surface", eye, near);
}

void append_stones(std::string& text, const PovSpace& space, const SeaFloor& floor) {
  append_shapes(text, space, floor.stones, "Stone");
  for (const StoneInstance& stone : floor.stone_instances) {
    text += fmt::format("object{{Stone{} scale", stone.shape);
    append_vector(text, 5, stone.size.x, stone.size.y, stone.size.z);
    // The mirror turns the other way round, and so do left-handed turns.
    text += "rotate y*" + number_text(-degrees(stone.turn), 3) + " translate";
    append_point(text, space, stone.at);
    text += fmt::format(" texture{{Rock_Texture({})}}}}\n", stone.look);
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
