#include <algorithm>
#include <cmath>

#include "emit/solid.h"

namespace frond {

namespace {

constexpr int kTentacles = 10, kBends = 4, kRound = 4;

/// One of width 1 when it is open, along +y.
Surface polyp_surface(double open) {
  Surface polyp;
  auto o = static_cast<float>(open);
  for (int t = 0; t < kTentacles; ++t) {
    bool inner = t % 2 == 1;
    float turn = 2 * static_cast<float>(kPi) * static_cast<float>(t) / kTentacles, c = std::cos(turn),
          s = std::sin(turn);
    Vec3 out(c, 0, s), side(-s, 0, c), at = 0.13f * out;
    float step = (inner ? 0.10f : 0.125f) * glm::mix(0.3f, 1.0f, o);
    auto first = static_cast<std::uint32_t>(polyp.position.size());
    for (int k = 0; k <= kBends; ++k) {
      float along = static_cast<float>(k) / kBends;
      float lean = glm::mix(-0.5f, (inner ? 0.2f : 0.5f) + 0.9f * along, o);
      Vec3 direction = std::sin(lean) * out + std::cos(lean) * Vec3(0, 1, 0),
           up = glm::cross(side, direction);
      float thick = 0.05f * (1 - 0.6f * along) * glm::mix(0.7f, 1.0f, o);
      for (int r = 0; r < kRound; ++r) {
        float a = 2 * static_cast<float>(kPi) * static_cast<float>(r) / kRound;
        Vec3 normal = std::cos(a) * side + std::sin(a) * up;
        polyp.position.push_back(at + thick * normal);
        polyp.normal.push_back(normal);
      }
      at += step * direction;
    }
    auto id = [&](int k, int r) { return first + static_cast<std::uint32_t>(k * kRound + r % kRound); };
    for (int k = 0; k < kBends; ++k)
      for (int r = 0; r < kRound; ++r) {
        polyp.triangle.push_back({id(k, r), id(k + 1, r), id(k, r + 1)});
        polyp.triangle.push_back({id(k, r + 1), id(k + 1, r), id(k + 1, r + 1)});
      }
    polyp.triangle.push_back({id(kBends, 0), id(kBends, 2), id(kBends, 1)});
    polyp.triangle.push_back({id(kBends, 0), id(kBends, 3), id(kBends, 2)});
  }
  return polyp;
}

}  // namespace

ObjectText polyps_text(const PovSpace& space, const DrawnPolyps& drawn, double time) {
  std::string lines;
  for (std::size_t i = 0; i < drawn.frames.size(); ++i)
    append_object(lines, space, "Polyp", drawn.frames[i], drawn.positions[i]);
  if (lines.empty()) return {};
  std::string text = "#declare Polyp = ";
  append_mesh(text, space, polyp_surface(std::clamp(drawn.polyps->open.at(time), 0.0, 1.0)));
  text += "\nunion{\n" + lines + "texture{";
  append_call(text, "Reef_Polyp", drawn.color, number_text(drawn.polyps->glow, 4));
  return {text + "}}\n", 1};
}

}  // namespace frond
