#include "emit/streaks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "emit/setting_parts.h"

namespace frond {

namespace {

constexpr int kShares = 16;  // textures of streaks
constexpr float kClearest = 0.004f,
                kShareStep = 1.45f;  // share of the light of the first, and from one to the next

int share_class(float share) {
  return std::clamp(static_cast<int>(std::lround(std::log(share / kClearest) / std::log(kShareStep))), 0,
                    kShares - 1);
}

}  // namespace

std::string streak_mesh_text(const PovSpace& space, std::span<const Streak> streaks, Vec3 eye, StreakEnd end,
                             std::string_view macro, Vec3 light) {
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
    text += fmt::format(",texture{{{}({},{})}}", macro, vector_text(light),
                        number_text(kClearest * std::pow(kShareStep, k)));
  text += fmt::format("}}\nface_indices{{{}{}}}\n", (round ? 1 : 2) * streaks.size(), faces);
  if (round) {
    text += fmt::format("uv_indices{{{}", streaks.size());
    for (std::size_t i = 0; i < streaks.size(); ++i) text += ",<0,1,2>";
    text += "}\n";
  }
  return text + "hollow no_shadow no_reflection}\n";
}

}  // namespace frond
