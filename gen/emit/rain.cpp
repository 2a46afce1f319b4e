#include "emit/rain.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.h"
#include "draw/rain.h"
#include "emit/setting_parts.h"
#include "model/wetness.h"
#include "settings/settings.h"

namespace frond {

std::string rain_text(const Scene& scene, double time) {
  if (!is_rainy(scene.stage)) return {};
  Stage now = stage_at(scene.stage, time);
  std::string text = fmt::format("#declare Frond_Wet = {};\n", number_text(wet_share(now)));
  for (const WettingRow& row : kWettings)
    text += fmt::format("#declare {} = texture{{Rain_Film({},{})}}\n", row.texture,
                        vector_text(wet_colors(row)), number_text(row.film));
  RingField rings = ring_field(now.rain->rate.at(0), scene.film);
  text += fmt::format("#declare Frond_Rings = array[4]{{{},{},{},{}}};\n", number_text(rings.layers),
                      number_text(rings.cell), number_text(rings.life), number_text(rings.share));
  if (double mist = now.rain->mist.at(0); mist > 0) {
    Vec3 from = scene.stage.camera.look_at.at(0);
    text += fmt::format("Rain_Mist({},{},{})\n", vector_text(drawn_daylight(now).fog), number_text(mist),
                        number_text(static_cast<double>(scene.ground->height({from.x, from.z}))));
  }
  return text;
}

namespace {

constexpr int kShares = 16;  // textures of streaks
constexpr float kClearest = 0.004f,
                kShareStep = 1.45f;  // share of the light of the first, and from one to the next

int share_class(float share) {
  return std::clamp(static_cast<int>(std::lround(std::log(share / kClearest) / std::log(kShareStep))), 0,
                    kShares - 1);
}

/// A drop is as bright as what it gathers from a wide part of the sky (Garg and Nayar 2007).
Vec3 drop_light(const Daylight& light) { return 0.9f * (0.7f * light.above + 0.3f * light.aside); }

}  // namespace

std::string streaks_text(const PovSpace& space, const Scene& scene, double time) {
  std::vector<Streak> streaks = rain_streaks(scene, time);
  if (streaks.empty()) return {};
  Vec3 eye = scene.stage.camera.location.at(time);
  std::string places, faces;
  for (std::size_t i = 0; i < streaks.size(); ++i) {
    const Streak& s = streaks[i];
    Vec3 middle = 0.5f * (s.top + s.bottom), along = s.bottom - s.top;
    Vec3 across = glm::cross(along, middle - eye);
    across *= 0.5f * s.width / std::max(glm::length(across), 1e-9f);
    for (Vec3 at : {s.top - across, s.top + across, s.bottom + across, s.bottom - across})
      places += ',', append_point(places, space, at);
    faces += fmt::format(",<{0},{1},{2}>,{4},<{0},{2},{3}>,{4}", 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3,
                         share_class(s.share));
  }
  std::string text =
      fmt::format("mesh2{{\nvertex_vectors{{{}{}}}\ntexture_list{{{}", 4 * streaks.size(), places, kShares);
  std::string light = vector_text(drop_light(drawn_daylight(stage_at(scene.stage, time))));
  for (int k = 0; k < kShares; ++k)
    text += fmt::format(",texture{{Rain_Streak({},{})}}", light,
                        number_text(kClearest * std::pow(kShareStep, k)));
  return text + fmt::format("}}\nface_indices{{{}{}}}\nhollow no_shadow no_reflection}}\n",
                            2 * streaks.size(), faces);
}

}  // namespace frond
