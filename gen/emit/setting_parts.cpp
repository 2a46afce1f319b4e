#include "emit/setting_parts.h"

#include <cmath>

#include "core/text.h"

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

std::string eye_text(const Scene& scene, double time) {
  return direction_text(scene.stage.camera.location.at(time));
}

std::string look_text(const Scene& scene, double time) {
  return direction_text(scene.stage.camera.look_at.at(time));
}

std::string floor_text(const PovSpace& space, const Scene& scene, std::string_view texture) {
  std::string text = "object{\n";
  append_mesh(text, space, scene.ground->floor());
  text += "\ntexture{";
  text += texture;
  return text + "}}\n";
}

void append_name(std::string& text, std::string_view name, std::size_t index) {
  text += name;
  append_integer(text, static_cast<long long>(index));
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

void append_patches(std::string& text, const PovSpace& space, const std::vector<Patch>& patches,
                    std::string_view name, std::string_view texture, const std::vector<bool>& missing) {
  std::size_t start = text.size();
  text += "union{\n";
  std::size_t empty = text.size();
  for (const Patch& patch : patches) {
    auto shape = static_cast<std::size_t>(patch.shape);
    if (!missing.empty() && missing[shape]) continue;
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

namespace {

void append_turf(std::string& text, const PovSpace& space, const Lawn& lawn, const std::string& grass) {
  if (lawn.turf_patches.empty()) return;
  std::vector<bool> bare;
  for (std::size_t i = 0; i < lawn.turf.size(); ++i) {
    const Turf& turf = lawn.turf[i];
    append_name(text, "#declare Turf", i);
    text += " = ";
    append_mesh(text, space, turf.blades);
    text += "\n";
    bare.push_back(turf.flowers.triangle.empty());
    if (bare.back()) continue;
    append_name(text, "#declare Bloom", i);
    text += " = ";
    append_mesh(text, space, turf.flowers);
    text += "\n";
  }
  append_patches(text, space, lawn.turf_patches, "Turf", "texture{Meadow_Blade(" + grass + ")}");
  append_patches(text, space, lawn.turf_patches, "Bloom", "texture{Meadow_Bloom()}", bare);
}

}  // namespace

std::string lawn_text(const PovSpace& space, const Scene& scene, const Color& grass, const Color& gravel) {
  const auto& lawn = static_cast<const Lawn&>(*scene.ground);
  std::string green = color_text(grass);
  std::string text = floor_text(space, scene, "Meadow_Ground(" + green + ")");
  append_turf(text, space, lawn, green);
  if (lawn.gravel_patches.empty()) return text;
  append_shapes(text, space, lawn.gravel, "Gravel");
  append_patches(text, space, lawn.gravel_patches, "Gravel",
                 "texture{Garden_Gravel(" + color_text(gravel) + ")}");
  return text;
}

}  // namespace frond
