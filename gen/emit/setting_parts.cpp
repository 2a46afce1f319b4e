#include "emit/setting_parts.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
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

Daytime daytime(Vec3 sun) {
  struct Hour {
    double height;  // of the sun, degrees
    Vec3 zenith, horizon, sunlight, glow, cloud;
  };
  static constexpr Hour kHours[] = {
      {-12,
       {0.012f, 0.018f, 0.05f},
       {0.03f, 0.04f, 0.08f},
       {0.10f, 0.13f, 0.20f},
       Vec3(0),
       {0.05f, 0.06f, 0.09f}},
      {-2,
       {0.09f, 0.13f, 0.28f},
       {0.50f, 0.35f, 0.34f},
       {0.55f, 0.26f, 0.16f},
       {0.85f, 0.34f, 0.16f},
       {0.62f, 0.38f, 0.38f}},
      {6,
       {0.20f, 0.31f, 0.54f},
       {1.00f, 0.75f, 0.51f},
       {2.6f, 1.5f, 0.76f},
       {1.1f, 0.73f, 0.38f},
       {1.05f, 0.82f, 0.68f}},
      {22,
       {0.22f, 0.42f, 0.74f},
       {0.92f, 0.91f, 0.83f},
       {3.1f, 2.45f, 1.65f},
       {0.7f, 0.66f, 0.55f},
       {1.05f, 1.01f, 0.96f}},
      {60,
       {0.22f, 0.45f, 0.79f},
       {0.87f, 0.93f, 0.95f},
       {3.0f, 2.7f, 2.2f},
       {0.45f, 0.45f, 0.43f},
       {1.05f, 1.05f, 1.04f}},
  };
  sun = glm::normalize(sun);
  double height = std::clamp(degrees(std::asin(static_cast<double>(sun.y))), -12.0, 60.0);
  std::size_t i = 0;
  while (i + 2 < std::size(kHours) && kHours[i + 1].height < height) ++i;
  const Hour &a = kHours[i], &b = kHours[i + 1];
  auto share = static_cast<float>((height - a.height) / (b.height - a.height));
  Daytime day;
  day.sun =
      glm::normalize(height < -6 ? Vec3(0.4f, 0.6f, -0.5f) : Vec3(sun.x, std::max(sun.y, 0.05f), sun.z));
  day.zenith = glm::mix(a.zenith, b.zenith, share);
  day.horizon = glm::mix(a.horizon, b.horizon, share);
  day.sunlight = glm::mix(a.sunlight, b.sunlight, share);
  day.glow = glm::mix(a.glow, b.glow, share);
  day.cloud = glm::mix(a.cloud, b.cloud, share);
  return day;
}

namespace {

std::string vectors_text(std::initializer_list<Vec3> list) {
  std::string text;
  for (const Vec3& v : list) {
    text += text.empty() ? "<" : ",<";
    append_list(text, 4, v.x, v.y, v.z);
    text += '>';
  }
  return text;
}

}  // namespace

std::string sky_text(const Daytime& day) { return vectors_text({day.zenith, day.horizon}); }

std::string sun_text(const Daytime& day) {
  return direction_text(day.sun) + "," + vectors_text({day.sunlight, day.glow, day.cloud});
}

Ambience ambience(const Daytime& day, const Color& ground) {
  Ambience light;
  light.sun = day.sun;
  light.sunlight = day.sunlight;
  light.zenith = day.zenith;
  light.horizon = day.horizon;
  light.ground = 0.48f * linear(ground);  // its textures are darker than the colour, and matt
  light.below = light.ground * (0.5f * day.sunlight * day.sun.y + 0.4f * (day.zenith + day.horizon));
  return light;
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
