#include <algorithm>
#include <cmath>

#include "emit/solid.h"

namespace frond {

namespace {

constexpr int kSteps = 8;           // from the valley to the ridge
constexpr float kAbove = 0.13f;     // of the wall's height: how far its crest stands above the wall
constexpr float kBelow = 0.2f;      // and how deep its foot lies in it
constexpr double kBrighter = 1.12;  // than the wall, as light comes through its edge

/// One that runs up a wall of width and height 1 along +x, 1 thick; u of its `uv` is as on the wall.
Surface septum_surface() {
  Surface septum;
  for (int k = 0; k <= kSteps; ++k) {
    float x = static_cast<float>(k) / kSteps - 0.5f, slope = std::cos(static_cast<float>(kPi) * x);
    float wall = 0.5f * std::sin(static_cast<float>(kPi) * x);
    // It is highest on the wall's shoulder, and ends in the valley and on the ridge.
    float crest = kAbove * std::pow(std::max(0.0f, slope), 0.5f) * (1 + 0.8f * x);
    float tone = std::clamp(0.5f + 0.95f * wall, 0.0f, 1.0f);
    for (int side : {-1, 0, 1}) {
      septum.position.push_back(
          {x * 1.08f, wall + (side == 0 ? crest : -kBelow), 0.5f * static_cast<float>(side)});
      septum.uv.push_back({std::min(1.0f, tone + (side == 0 ? 0.12f : 0)), 1});
    }
  }
  for (std::uint32_t k = 0; k < kSteps; ++k)
    for (std::uint32_t side = 0; side < 2; ++side)
      add_quad(septum, 3 * k + side, 3 * k + side + 1, 3 * (k + 1) + side + 1, 3 * (k + 1) + side);
  set_normals(septum);
  return septum;
}

}  // namespace

ObjectText septa_text(const PovSpace& space, const DrawnSepta& drawn) {
  std::string lines;
  for (std::size_t i = 0; i < drawn.frames.size(); ++i)
    append_object(lines, space, "Septum", drawn.frames[i], drawn.positions[i]);
  if (lines.empty()) return {};
  std::string text;
  append_front(text, static_cast<double>(drawn.front));
  text += "#ifndef(Septum)#declare Septum = ";
  append_mesh(text, space, septum_surface());
  Material material = *drawn.material;
  material.color = scaled(material.color, kBrighter);
  text += "#end\nunion{\n" + lines + material_text(material);
  if (!append_matrix(text, space, axes_of(drawn.turn, drawn.scale), drawn.position)) return {};
  return {text + "}\n", 1};
}

}  // namespace frond
