#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/frame_name.h"
#include "core/linear.h"
#include "draw/eyes.h"
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

/// Of sunlit water as the sheets of light and the surface take it, as text.
struct WaterColors {
  std::string near, surface;
};

WaterColors water_colors(const Water& water, const Daylight& light, float exposed) {
  if (!water.type) {
    exposed *= static_cast<float>(water.daylight);
    std::string near = color_text(exposed == 1 ? water.near : seen_color(exposed * linear(water.near)));
    return {near, near};
  }
  // Both are lighter than the veil at the horizon; at the surface no daylight is lost yet.
  Vec3 near = 1.5f * light.fog;
  Vec3 shallow = water_optics(*water.type, 0).veil / water_optics(*water.type, water.depth).veil;
  return {color_text(seen_color(near)), color_text(seen_color(near * shallow))};
}

std::string backdrop_text(const Daylight& light) {
  std::string text = fmt::format("#declare Water_Backdrop = array[{}]{{", light.backdrop.size());
  for (const BackdropStop& stop : light.backdrop) {
    if (text.back() != '{') text += ',';
    append_vector(text, 6, stop.light.r, stop.light.g, stop.light.b, stop.height);
  }
  return text + "};\n";
}

/// What is declared before the macros that read it, where the water is of a type or the day not bright.
std::string optics_text(const Scene& scene, const Daylight& light, double time) {
  const auto& water = scene.setup.block<Water>();
  std::string text;
  auto declare = [&](std::string_view name, const std::string& value) {
    text += fmt::format("#declare Water_{} = {};\n", name, value);
  };
  // Lamps stay below the caustics, which would filter their light, too.
  constexpr double kCeiling = 2.6, kOverLens = 0.3;  // metres: as in the include file; of the lamps
  if (water.strobe) {
    double ceiling = kCeiling;
    for (const Eye& eye : eyes(scene)) ceiling = std::max(ceiling, static_cast<double>(eye.at.y) + kOverLens);
    if (ceiling > kCeiling) declare("Ceiling", number_text(ceiling));
  }
  if (water.daylight != 1) declare("Day", number_text(water.daylight));
  if (!water.type) {
    if (water.daylight != 1) declare("Lit", vector_text(Vec3(static_cast<float>(water.daylight))));
    return text;
  }
  WaterOptics optics = water_optics(*water.type, water.depth);
  declare("Lit", vector_text(light.sunlight));
  declare("Direct", vector_text(optics.direct));
  declare("Backscatter", vector_text(optics.backscatter));
  constexpr double kUnderSurface = 0.5;  // metres, at least, that the camera is
  if (water.depth > 0)
    declare("Depth",
            number_text(std::max(water.depth, scene.setup.camera.location.at(time).y + kUnderSurface)));
  return text;
}

/// The lamps that go with the camera.
std::string strobe_text(const Strobe& strobe, const Scene& scene, double time, Vec3 exposed) {
  constexpr float kAbove = 0.2f;  // metres over the lens
  Eye eye = eye_at(scene, time);
  auto aside = static_cast<float>(strobe.count > 1 ? strobe.apart / 2 : 0);
  Vec3 right = glm::cross(eye.ahead, eye.up), above = eye.at + kAbove * eye.up;
  std::string text = fmt::format("#declare Water_Strobes = array[{}]{{", strobe.count);
  for (int i = 0; i < strobe.count; ++i)
    text += (i > 0 ? "," : "") + direction_text(above + (i > 0 ? aside : -aside) * right);
  auto power = static_cast<float>(strobe.power * strobe.reach * strobe.reach / strobe.count);
  Vec3 light = exposed * power * kSunAtSurface * linear(strobe.color);
  return text + "};\n" + call_text("Water_Strobe", look_text(scene, time), strobe.angle, vector_text(light)) +
         '\n';
}

/// Its macros take metres, in POV-Ray's axes.
std::string water_text(const Scene& scene, double time) {
  const auto& water = scene.setup.block<Water>();
  std::string eye = eye_text(scene, time), look = look_text(scene, time);
  auto exposed = static_cast<float>(std::exp2(scene.setup.camera.stops()));
  Daylight light = drawn_daylight(scene.setup);
  WaterColors colors = water_colors(water, light, exposed);
  std::string sun = direction_text(water.sun);
  double contrast = caustic_contrast(water);
  std::string text = globals_text("Water") + backdrop_text(light) + optics_text(scene, light, time);
  append_call(text, "Water_Setting", eye, light_text(light.fog), light.fade, sun, light_text(light.sunlight),
              contrast * water.caustics, '"' + caustics_name(scene, time) + '"');
  text += '\n';
  if (water.strobe) text += strobe_text(*water.strobe, scene, time, exposed * white_balance(water).lamps);
  if (scene.film.transparent()) return text;
  if (double shafts = contrast * water.daylight * water.shafts; shafts > 0)
    text += call_text("Water_Shafts", eye, look, colors.near, sun, shafts) + '\n';
  if (water.particles > 0) text += call_text("Water_Particles", eye, look, water.particles) + '\n';
  return text + call_text("Water_Surface", eye, colors.surface);
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
