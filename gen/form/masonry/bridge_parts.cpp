#include "masonry/bridge_parts.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"

namespace frond {

Surface bar_surface(const Arch& arch, const Bar& bar) {
  Vec3 size(bar.to - bar.from, bar.high - bar.low, bar.far - bar.near);
  Surface surface = block_surface({size, bar.bevel, {bar.cuts, bar.sides, bar.sides}});
  double s = (bar.from + bar.to) / 2, n = (bar.low + bar.high) / 2, z = (bar.near + bar.far) / 2;
  bend(surface, [&](Vec3 p) {
    ArchPoint on = arch_at(arch, s + p.x);
    glm::dvec2 at = on.at + (bar.upright ? glm::dvec2(0, 1) : on.up) * (n + p.y);
    return Vec3(at.x, at.y, z + p.z);
  });
  return surface;
}

BridgePiece piece_of(BridgePart part, Surface world, Vec3 at, Quat turn) {
  Quat back = glm::conjugate(turn);
  for (Vec3& p : world.position) p = back * (p - at);
  for (Vec3& n : world.normal) n = back * n;
  return {part, std::move(world), at, turn};
}

BridgePiece bar_piece(const Arch& arch, BridgePart part, const Bar& bar) {
  ArchPoint from = arch_at(arch, bar.from), to = arch_at(arch, bar.to),
            middle = arch_at(arch, (bar.from + bar.to) / 2);
  glm::dvec2 chord = to.at - from.at,
             at = middle.at + (bar.upright ? glm::dvec2(0, 1) : middle.up) * ((bar.low + bar.high) / 2);
  Quat turn = glm::angleAxis(static_cast<float>(std::atan2(chord.y, chord.x)), Vec3(0, 0, 1));
  return piece_of(part, bar_surface(arch, bar), Vec3(at.x, at.y, (bar.near + bar.far) / 2), turn);
}

BridgePiece post_piece(Vec2 at, double foot, double head, double width, float bevel) {
  auto w = static_cast<float>(width);
  Surface surface = block_surface({Vec3(head - foot, w, w), bevel, {4, 1, 1}});
  // Its own x, along which the grain runs, points upward.
  Quat turn = glm::angleAxis(static_cast<float>(kPi / 2), Vec3(0, 0, 1));
  return {BridgePart::post, std::move(surface), Vec3(at.x, (foot + head) / 2, at.y), turn};
}

BridgePiece cap_piece(Vec2 at, double head, double width) {
  auto w = static_cast<float>(width), brim = 0.22f * w, peak = 0.24f * w;
  Surface surface = block_surface({Vec3(1.32f * w, brim, 1.32f * w), 0.05f * w, {4, 1, 4}});
  bend(surface, [&](Vec3 p) {
    if (p.y <= 0) return p;
    float out = std::max(std::abs(p.x), std::abs(p.z)) / (0.66f * w);
    return p + Vec3(0, peak * (1 - std::min(out, 1.0f)), 0);
  });
  return {BridgePart::cap, std::move(surface), Vec3(at.x, static_cast<float>(head) + 0.45f * brim, at.y),
          Quat(1, 0, 0, 0)};
}

void roughen(Surface& surface, float depth, float size, Seed seed) {
  Vec3 shift = random_shift(seed);
  for (std::size_t i = 0; i < surface.position.size(); ++i)
    surface.position[i] += surface.normal[i] *
                           (depth * static_cast<float>(fractal_noise(surface.position[i] / size + shift, 2)));
  set_normals(surface);
}

}  // namespace frond
