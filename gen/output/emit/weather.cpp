#include "emit/weather.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "draw/bough_snow.h"
#include "draw/eyes.h"
#include "draw/rain.h"
#include "draw/snowfall.h"
#include "emit/setting_parts.h"
#include "model/wetness.h"
#include "settings/settings.h"

namespace frond {

namespace {

/// What ends an object of snow on boughs.
constexpr std::string_view kHeapTexture = "texture{Snow_Lying(rgb<0.97,0.975,0.985>,rgb 1,1,0,0,0)}}\n";

/// A drop is as bright as what it gathers from a wide part of the sky (Garg and Nayar 2007).
Vec3 drop_light(const Daylight& light) { return 0.9f * (0.7f * light.above + 0.3f * light.aside); }

/// A flake is white and shows what light comes from all sides.
Vec3 flake_light(const Daylight& light) {
  return 0.9f * (0.4f * light.above + 0.25f * light.aside + 0.35f * light.below + 0.25f * light.sunlight);
}

constexpr int kShares = 16;  // textures of streaks
constexpr float kClearest = 0.004f,
                kShareStep = 1.45f;  // share of the light of the first, and from one to the next

int share_class(float share) {
  return std::clamp(static_cast<int>(std::lround(std::log(share / kClearest) / std::log(kShareStep))), 0,
                    kShares - 1);
}

enum class StreakEnd {
  cut,   // quads
  round  // triangles whose `uv` have the streak as the disc of radius 1 about their origin
};

/// Streaks that face the eye, as one mesh. `macro`, called with the light and a share of it, stands in their
/// textures.
std::string streak_mesh_text(const PovSpace& space, std::span<const Streak> streaks, Vec3 eye, StreakEnd end,
                             std::string_view macro, Vec3 light) {
  if (streaks.empty()) return {};
  bool round = end == StreakEnd::round;
  std::string places, faces;
  for (std::size_t i = 0; i < streaks.size(); ++i) {
    const Streak& s = streaks[i];
    Vec3 middle = 0.5f * (s.top + s.bottom), along = s.bottom - s.top;
    Vec3 across = glm::cross(along, middle - eye);
    across *= 0.5f * s.width / std::max(glm::length(across), 1e-9f);
    int share = share_class(s.share);
    if (round) {
      Vec3 wide = std::sqrt(3.0f) * across;
      for (Vec3 at : {middle - along, s.bottom + wide, s.bottom - wide})
        places += ',', append_point(places, space, at, 3);
      faces += fmt::format(",<{},{},{}>,{}", 3 * i, 3 * i + 1, 3 * i + 2, share);
      continue;
    }
    for (Vec3 at : {s.top - across, s.top + across, s.bottom + across, s.bottom - across})
      places += ',', append_point(places, space, at);
    faces +=
        fmt::format(",<{0},{1},{2}>,{4},<{0},{2},{3}>,{4}", 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3, share);
  }
  std::string text =
      fmt::format("mesh2{{\nvertex_vectors{{{}{}}}\n", (round ? 3 : 4) * streaks.size(), places);
  if (round) text += "uv_vectors{3,<0,2>,<1.7321,-1>,<-1.7321,-1>}\n";
  text += fmt::format("texture_list{{{}", kShares);
  for (int k = 0; k < kShares; ++k)
    text += fmt::format(",texture{{{}}}", call_text(macro, light, kClearest * std::pow(kShareStep, k)));
  text += fmt::format("}}\nface_indices{{{}{}}}\n", (round ? 1 : 2) * streaks.size(), faces);
  if (round) {
    text += fmt::format("uv_indices{{{}", streaks.size());
    for (std::size_t i = 0; i < streaks.size(); ++i) text += ",<0,1,2>";
    text += "}\n";
  }
  return text + "hollow no_shadow no_reflection}\n";
}

}  // namespace

std::string rain_text(const Scene& scene, double time) {
  if (!is_rainy(scene.setup)) return {};
  SceneSetup now = setup_at(scene.setup, time);
  std::string text = fmt::format("#declare Frond_Wet = {};\n", number_text(wet_share(now)));
  for (const WettingRow& row : kWettings)
    text += fmt::format("#declare {} = texture{{{}}}\n", row.texture,
                        call_text("Rain_Film", wet_colors(row), row.film));
  auto declare = [&](std::string_view name, double a, double b, double c, double d) {
    text += fmt::format("#declare {} = array[4]{{", name);
    append_list(text, 5, a, b, c, d);
    text += "};\n";
  };
  RingField rings = ring_field(now.rain->rate.at(0), scene.film);
  declare("Frond_Rings", rings.layers, rings.cell, rings.life, rings.share);
  Eye eye = eye_at(scene, time);
  declare("Frond_Rings_Eye", eye.at.x, eye.at.y, eye.at.z, eye.pixel);
  if (double mist = now.rain->mist.at(0); mist > 0) {
    Vec3 from = scene.setup.camera.look_at.at(0);
    append_call(text, "Rain_Mist", drawn_daylight(now).fog, mist, scene.ground->height({from.x, from.z}));
    text += '\n';
  }
  return text;
}

std::string bough_snow_declarations(const PovSpace& space, const Scene& scene) {
  if (std::ranges::none_of(scene.specimens, [](const Specimen& s) { return s.load != nullptr; })) return {};
  std::string text = "#declare Snow_Tuft = ";
  append_mesh(text, space, tuft_surface());
  return text + '\n';
}

ObjectText bough_snow_text(const PovSpace& space, const DrawList& drawn, double time, double pixel) {
  BoughSnow snow = bough_snow(drawn, time, pixel);
  ObjectText all;
  MeshText how{.decimals = decimals_for(space, pixel)};
  for (const Surface* surface : {&snow.heaps, &snow.ridges}) {
    if (!has_faces(*surface)) continue;
    all.text += "object{";
    if (surface == &snow.ridges) how.flat = -1;
    append_mesh(all.text, space, *surface, how);
    all.text += kHeapTexture;
    ++all.objects;
  }
  std::string lines;
  for (const OrganPlace& tuft : snow.tufts)
    append_object(lines, space, "Snow_Tuft", axes_of(tuft.turn, tuft.scale), tuft.at,
                  matrix_text_for(space, 0.2, pixel));
  if (lines.empty()) return all;
  all.text += std::string(group_opening(lines)) + lines + std::string(kHeapTexture);
  ++all.objects;
  return all;
}

std::string falling_text(const PovSpace& space, const Scene& scene, double time) {
  std::vector<Streak> drops = rain_streaks(scene, time), flakes = snow_flakes(scene, time),
                      powder = snow_powder(scene, time);
  flakes.insert(flakes.end(), powder.begin(), powder.end());
  if (drops.empty() && flakes.empty()) return {};
  Vec3 eye = scene.setup.camera.location.at(time);
  Daylight light = drawn_daylight(setup_at(scene.setup, time));
  return streak_mesh_text(space, drops, eye, StreakEnd::cut, "Rain_Streak", drop_light(light)) +
         streak_mesh_text(space, flakes, eye, StreakEnd::round, "Snow_Flake", flake_light(light));
}

}  // namespace frond
