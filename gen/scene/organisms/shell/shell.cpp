#include "organisms/shell/shell.h"

#include <algorithm>
#include <cmath>

#include "core/bounds.h"
#include "organisms/shell/coil.h"

namespace frond {

namespace {

constexpr double kYoungest = 1e-3;  // share of its size at which it begins

Bounds turned_bounds(const Surface& s, const glm::mat3& turn) {
  Bounds box;
  for (const Vec3& p : s.position) box.extend(turn * p);
  return box;
}

/// The valves, or the one, and where they hinge.
struct Valves {
  Surface surface;
  float hinge = 0;
};

/// From the frame of the spiral to how it lies: the tip, or the margins, up and then tilted.
glm::mat3 lying(const ShellParams& params) {
  auto roll = static_cast<float>(params.roll), tilt = static_cast<float>(params.tilt);
  if (params.coiled())
    return glm::mat3_cast(glm::angleAxis(-tilt, Vec3(0, 0, 1)) * glm::angleAxis(roll, Vec3(0, 1, 0)));
  return glm::mat3_cast(glm::angleAxis(static_cast<float>(kPi / 2) - tilt, Vec3(0, 0, 1)) *
                        glm::angleAxis(roll, Vec3(1, 0, 0)));
}

void open_valve(Surface& valve, float hinge, double by) {
  Quat turn = glm::angleAxis(static_cast<float>(by), Vec3(0, 0, 1));
  Vec3 axis(hinge, 0, 0);
  for (Vec3& p : valve.position) p = axis + turn * (p - axis);
  for (Vec3& n : valve.normal) n = turn * n;
}

/// When so many radians of growth are still to come.
Valves valves_at(const ShellParams& params, const ShellEdge& edge, double still, double gape) {
  Valves all{shell_wall(params, edge, still, false)};
  if (params.coiled()) return all;
  for (const Vec3& p : all.surface.position) all.hinge = std::min(all.hinge, p.x);
  open_valve(all.surface, all.hinge, 0.5 * gape);
  if (params.form == ShellForm::valve) return all;
  Surface other = shell_wall(params, edge, still, true);
  open_valve(other, all.hinge, -0.5 * gape);
  append(all.surface, other);
  return all;
}

Material painted(const ShellLook& look, const Drawing& picture, double scale, Seed seed) {
  auto bright = static_cast<float>(1 + look.variation * seed.child("brightness").range(-1, 1));
  Material material{
      .matter = Matter::shell, .color = look.color, .second = {bright, bright, bright}, .scale = scale};
  material.gloss = look.gloss;
  material.picture = picture.names[0];
  return material;
}

}  // namespace

Drawing shell_drawing_of(const ShellParams& params) {
  return shell_drawing(params.look, lines_a_cell(params), params.coiled() ? params.whorls : 1);
}

Model grow_shell(const ShellParams& params, double share, double gape, Seed seed) {
  ShellEdge edge = shell_edge(params);
  // The size that it has come to, as radians that are still to come; what is younger than its first line is
  // that line, smaller.
  constexpr double kFirstLine = 0.9;  // of all growth
  double first = kFirstLine * 2 * kPi * params.whorls;
  double size = std::max(share, kYoungest), grown = std::min(-std::log(size) / params.rate(), first);
  double shrunk = size / std::exp(-params.rate() * grown);
  glm::mat3 turn = lying(params);
  Valves valves = valves_at(params, edge, 0, 0);
  Bounds full = turned_bounds(valves.surface, turn);
  double unit = params.size / full.longest();
  if (grown > 0 || gape != 0) valves = valves_at(params, edge, grown, gape);
  Vec3 foot = full.foot() * static_cast<float>(size);
  if (grown > 0 && params.coiled())
    foot.y = turned_bounds(valves.surface, turn).low.y * static_cast<float>(shrunk);
  auto set_down = [&](Surface& s) {
    for (Vec3& p : s.position) p = (turn * p * static_cast<float>(shrunk) - foot) * static_cast<float>(unit);
    for (Vec3& n : s.normal) n = turn * n;
  };
  Model model;
  set_down(valves.surface);
  model.solids.place(model.solids.add_shape(
      {std::move(valves.surface), painted(params.look, shell_drawing_of(params), params.size, seed)}));
  if (!params.mantle) return model;
  const MantleLook& look = params.mantle->look;
  Surface tissue = shell_mantle(params, edge, grown, gape, valves.hinge);
  set_down(tissue);
  Material soft{.matter = Matter::mantle, .color = look.color, .second = look.second, .scale = params.size};
  soft.gloss = 0.5, soft.relief = look.glow;
  soft.picture = mantle_drawing(look).names[0];
  model.solids.place(model.solids.add_shape({std::move(tissue), soft}));
  return model;
}

}  // namespace frond
