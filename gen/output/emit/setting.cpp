#include "emit/setting.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/linear.h"
#include "draw/eyes.h"
#include "emit/setting_parts.h"
#include "emit/solid.h"
#include "emit/weather.h"
#include "settings/forest.h"
#include "settings/settings.h"

namespace frond {

#define FROND_DECLARE(name) SettingText name##_text();
FROND_SETTINGS(FROND_DECLARE)
#undef FROND_DECLARE

namespace {

const SettingText& text_of(const SceneSetup& setup) {
#define FROND_ROW(name) name##_text(),
  static const std::vector<SettingText> rows{FROND_SETTINGS(FROND_ROW)};
#undef FROND_ROW
  return rows[setup.setting];
}

void add_missing(std::vector<std::string_view>& names, std::initializer_list<std::string_view> more) {
  for (std::string_view name : more)
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

}  // namespace

std::string includes_text(const Scene& scene) {
  auto any = [&](auto has) { return std::ranges::any_of(scene.specimens, has); };
  std::vector<std::string_view> names = text_of(scene.setup).includes;
  if (any([](const Specimen& s) { return s.look.branches.coral(); })) add_missing(names, {"coral", "food"});
  if (any([](const Specimen& s) { return s.look.branches.plant(); })) add_missing(names, {"plant"});
  if (!scene.drawings.empty()) names.push_back("tree");
  if (any([](const Specimen& s) { return s.style.build == Build::voxels; })) names.push_back("voxel");
  if (any([](const Specimen& s) { return s.life.hanging.has_value(); })) names.push_back("ivy");
  for (std::string_view name : solid_includes(scene)) names.push_back(name);
  if (is_snowy(scene.setup)) add_missing(names, {"snow"});
  if (scene.far) names.push_back("far");
  if (is_rainy(scene.setup)) add_missing(names, {"rain"});
  std::string text;
  for (std::string_view name : names) {
    if (!text.empty()) text += '\n';
    text += fmt::format("#include \"frond_{}.inc\"", name);
  }
  return text;
}

std::optional<FloorTexture> floor_texture(const SceneSetup& setup) {
  const SettingText& text = text_of(setup);
  if (text.bare_floor.empty()) return std::nullopt;
  return FloorTexture{text.includes, text.bare_floor};
}

namespace {

/// What the textures of snow ask for, and that which lies over others.
std::string snow_text(const SceneSetup& setup, double time) {
  if (!is_snowy(setup)) return {};
  return fmt::format(
      "#declare Frond_Snow = {};\n#declare Frond_Frost = {};\n#declare Snow_Over = texture{{Snow_Layer()}}\n",
      number_text(setup.snow.depth.at(time)), number_text(setup.snow.frost.at(time)));
}

/// What the settings' macros leave out; nothing where that is nothing.
std::string background_text(const Film& film) {
  if (!film.transparent()) return {};
  return fmt::format("#declare Frond_Cutout = {};\n", static_cast<int>(film.background));
}

/// The colours of the ground at that time of the year.
std::string year_text(const SceneSetup& setup, double time) {
  if (!setup.year) return {};
  double year = setup.year->at(time);
  return fmt::format("#declare {} = {};\n#declare {} = {};\n", kYearGrass,
                     light_text(linear(grass_at(setup.block<Meadow>().grass, year))), kYearLitter,
                     light_text(linear(litter_at(setup.block<Forest>().litter, year))));
}

}  // namespace

std::string setting_text(const Scene& scene, double time) {
  std::string text = background_text(scene.film) + snow_text(scene.setup, time) + rain_text(scene, time) +
                     year_text(scene.setup, time) + text_of(scene.setup).surroundings(scene, time);
  return scene.far && !scene.film.transparent() ? text + '\n' + far_air_text(scene, time) : text;
}

std::optional<std::string> sky_scene_text(const PovSpace& space, const Scene& scene) {
  const SettingText& setting = text_of(scene.setup);
  if (!setting.sky || sun_moves(scene.setup)) return std::nullopt;
  std::string text =
      fmt::format("#version 3.7;\n#declare Frond_Unit = {};\n#declare Frond_Quality = 0;\n", space.unit);
  for (std::string_view name : setting.includes) text += fmt::format("#include \"frond_{}.inc\"\n", name);
  text += setting.surroundings(scene, 0) + "\ncamera{spherical location";
  append_point(text, space, eye_at(scene, 0).at);
  return text + " right x up y direction z angle 360 180}\n";
}

bool has_pictures(const SceneSetup& setup) { return text_of(setup).pictures; }

Result<std::vector<Picture>> setting_pictures(const Scene& scene, double time) {
  const SettingText& text = text_of(scene.setup);
  return text.pictures ? text.pictures(scene, time) : std::vector<Picture>();
}

std::string ground_text(const PovSpace& space, const Scene& scene) {
  if (scene.film.background == Background::transparent) return {};
  std::string text = text_of(scene.setup).ground(space, scene);
  return scene.far && !scene.film.transparent() ? text + far_text(space, scene) : text;
}

std::string adrift_text(const PovSpace& space, const Scene& scene, double time) {
  std::string text;
  std::size_t number = 0;
  for (const ScatteredInstances& kind : scene.ground->adrift(time, scene.film.length())) {
    std::string lines, name = fmt::format("Adrift{}", number);
    for (const ScatteredInstances::At& at : kind.at)
      append_object(lines, space, name, axes_of(at.turn, at.size), at.place);
    if (lines.empty()) continue;
    ++number;
    text += "#declare " + name + " = ";
    append_mesh(text, space, *kind.shape);
    text += "\nunion{\n" + lines + "texture{pigment{" + color_text(kind.color) +
            "}finish{ambient Frond_Ambient diffuse 0.6}}}\n";
  }
  return text;
}

}  // namespace frond
