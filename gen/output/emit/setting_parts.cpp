#include "emit/setting_parts.h"

#include <fmt/format.h>

#include <cmath>

#include "draw/ambience.h"
#include "draw/solids.h"
#include "settings/settings.h"

namespace frond {

std::string direction_text(Vec3 v) {
  std::string text;
  append_direction(text, v);
  return text;
}

std::string color_text(const Color& c) {
  std::string text;
  append_color(text, c);
  return text;
}

std::string light_text(Vec3 light) {
  std::string text = "rgb ";
  append_vector(text, 6, light.r, light.g, light.b);
  return text;
}

std::string eye_text(const Scene& scene, double time) {
  return direction_text(scene.setup.camera.location.at(time));
}

std::string look_text(const Scene& scene, double time) {
  return direction_text(scene.setup.camera.look_at.at(time));
}

std::string floor_text(const PovSpace& space, const Scene& scene, std::string_view texture) {
  std::string text = "object{\n";
  append_mesh(text, space, drawn_floor(scene));
  text += fmt::format("\ntexture{{{}}}", texture) + weather_over(false, is_rainy(scene.setup), Wetting::soil);
  for (const Specimen& s : scene.specimens) {
    const std::vector<Solid>& shapes = s.model.solids.shapes;
    if (shapes.empty() || shapes[0].material.matter != Matter::snow) continue;
    Bounds box = bounds_of(shapes[0].surface.position);  // of the ground
    text += "texture{Snow_Far(" + direction_text(box.middle()) + "," + number_text(box.size().x / 2) + ")}";
  }
  return text + "}\n";
}

std::string vector_text(Vec3 light) {
  std::string text;
  append_light(text, light);
  return text;
}

std::string sky_text(const Sky& sky, double clouds) {
  // Rows of one height, finer near the horizon, each from the sun's side to the other.
  static constexpr double kHeights[] = {0,    0.01, 0.02, 0.035, 0.055, 0.08, 0.11, 0.15,
                                        0.20, 0.28, 0.38, 0.50,  0.63,  0.78, 0.92, 1};
  constexpr int kTurns = 12;
  Vec3 flat(sky.sun.x, 0, sky.sun.z);
  flat = glm::length(flat) > 1e-4f ? glm::normalize(flat) : Vec3(0, 0, 1);
  Vec3 aside(flat.z, 0, -flat.x);
  std::string text = "#declare Sky_Clear = pigment{function{min(1,max(0,y))}pigment_map{\n";
  for (double height : kHeights) {
    text += fmt::format("[{} Sky_Round({})color_map{{", number_text(height, 3), direction_text(flat));
    double level = std::sqrt(1 - height * height);
    for (int i = 0; i <= kTurns; ++i) {
      double turn = kPi * i / kTurns;
      Vec3 direction = flat * static_cast<float>(level * std::cos(turn)) +
                       aside * static_cast<float>(level * std::sin(turn));
      text += fmt::format("[{} rgb{}]", number_text(static_cast<double>(i) / kTurns, 4),
                          vector_text(sky.from(direction + Vec3(0, height, 0))));
    }
    text += "}]\n";
  }
  text += "}}\n";
  append_call(text, "Meadow_Sky", direction_text(sky.sun), sky.glow, sky.cloud, sky.shade, clouds);
  return text + '\n';
}

std::string globals_text(std::string_view prefix) {
  return call_text(std::string(prefix) + "_Globals", kLightErrorBound) + '\n';
}

std::string air_text(const Sky& sky) { return vector_text(sky.zenith) + "," + vector_text(sky.horizon); }

std::string lamp_text(const Sky& sky) { return direction_text(sky.lamp) + "," + vector_text(sky.lamplight); }

std::string country_text(const Sky& sky, const Meadow& meadow, Vec3 air) {
  return sky_text(sky, meadow.clouds) + call_text("Meadow_Setting", lamp_text(sky), air, meadow.haze);
}

void append_shapes(std::string& text, const PovSpace& space, const std::vector<Surface>& shapes,
                   std::string_view name) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    text += fmt::format("#declare {}{} = ", name, i);
    append_mesh(text, space, shapes[i]);
    text += '\n';
  }
}

void append_patches(std::string& text, const PovSpace& space, const std::vector<Patch>& patches,
                    std::string_view name, std::string_view texture, const std::vector<bool>& missing) {
  std::size_t start = text.size();
  text += "union{\n";
  std::size_t empty = text.size();
  for (const Patch& patch : patches) {
    auto shape = static_cast<std::size_t>(patch.shape);
    if (!missing.empty() && missing[shape]) continue;
    append_object(text, space, fmt::format("{}{}", name, shape), patch.axes(), patch.at);
  }
  if (text.size() == empty) return text.resize(start);
  text += texture;
  text += "}\n";
}

namespace {

/// One of the meshes of all patches, declared and put there.
void append_turf(std::string& text, const PovSpace& space, const Lawn& lawn, Surface Turf::*part,
                 std::string_view name, const std::string& texture) {
  std::vector<bool> missing;
  for (std::size_t i = 0; i < lawn.turf.size(); ++i) {
    const Surface& mesh = lawn.turf[i].*part;
    missing.push_back(mesh.triangle.empty());
    if (missing.back()) continue;
    text += fmt::format("#declare {}{} = ", name, i);
    append_mesh(text, space, mesh);
    text += '\n';
  }
  append_patches(text, space, lawn.turf_patches, name, texture, missing);
}

}  // namespace

std::string lawn_text(const PovSpace& space, const Scene& scene, const Color& grass, const Color& gravel,
                      const Color& earth) {
  const auto& lawn = ground_as<Lawn>(*scene.ground);
  std::string green = scene.setup.year ? std::string(kYearGrass) : color_text(grass);
  std::string text;
  if (Mask map = lawn.map(); !map.empty()) declare_mask(text, space, map, "Grass_Map");
  text += floor_text(space, scene, "Meadow_Ground(" + green + ")");
  bool wet = is_rainy(scene.setup);
  std::string leaf = weather_over(is_snowy(scene.setup), wet, Wetting::leaf);
  append_turf(text, space, lawn, &Turf::blades, "Turf", "texture{Meadow_Blade(" + green + ")}" + leaf);
  append_turf(text, space, lawn, &Turf::leaves, "Leaf", "texture{Meadow_Leaf(" + green + ")}" + leaf);
  append_turf(text, space, lawn, &Turf::flowers, "Bloom", "texture{Meadow_Bloom()}");
  auto append_ground = [&](const std::vector<Surface>& shapes, const std::vector<Patch>& patches,
                           std::string_view name, const Color& color, Wetting wetting) {
    if (patches.empty()) return;
    append_shapes(text, space, shapes, name);
    append_patches(
        text, space, patches, name,
        fmt::format("texture{{Garden_{}({})}}", name, color_text(color)) + weather_over(false, wet, wetting));
  };
  append_ground(lawn.gravel, lawn.gravel_patches, "Gravel", gravel, Wetting::stone);
  append_ground(lawn.earth, lawn.earth_patches, "Earth", earth, Wetting::soil);
  return text;
}

}  // namespace frond
