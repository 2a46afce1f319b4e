#include "emit/snow.h"

#include <algorithm>
#include <vector>

#include "draw/bough_snow.h"
#include "draw/snowfall.h"
#include "emit/streaks.h"
#include "settings/settings.h"

namespace frond {

namespace {

/// What ends an object of snow on boughs.
constexpr std::string_view kHeapTexture = "texture{Snow_Lying(rgb<0.97,0.975,0.985>,rgb 1,1,0,0,0)}}\n";

/// A flake is white and shows what light comes from all sides.
Vec3 flake_light(const Daylight& light) {
  return 0.9f * (0.4f * light.above + 0.25f * light.aside + 0.35f * light.below + 0.25f * light.sunlight);
}

}  // namespace

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
  for (const OrganPlace& tuft : snow.tufts) {
    std::string line = "object{Snow_Tuft ";
    if (append_matrix(line, space, axes_of(tuft.turn, tuft.scale), tuft.at,
                      matrix_text_for(space, 0.2, pixel)))
      lines += line + "}\n";
  }
  if (lines.empty()) return all;
  all.text += std::string(group_opening(lines)) + lines + std::string(kHeapTexture);
  ++all.objects;
  return all;
}

std::string flakes_text(const PovSpace& space, const Scene& scene, double time) {
  std::vector<Streak> flakes = snow_flakes(scene, time), powder = snow_powder(scene, time);
  flakes.insert(flakes.end(), powder.begin(), powder.end());
  if (flakes.empty()) return {};
  return streak_mesh_text(space, flakes, scene.setup.camera.location.at(time), StreakEnd::round, "Snow_Flake",
                          flake_light(drawn_daylight(setup_at(scene.setup, time))));
}

}  // namespace frond
