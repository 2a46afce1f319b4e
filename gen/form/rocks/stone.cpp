#include "rocks/stone.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "core/noise.h"

namespace frond {

namespace {

/// A sphere of radius 1 as an icosahedron whose triangles are split in four, `detail` times.
Surface icosphere(int detail) {
  Surface s;
  float g = (1 + std::sqrt(5.0f)) / 2;
  for (float a : {-1.0f, 1.0f})
    for (float b : {-g, g})
      for (Vec3 p : {Vec3(a, b, 0), Vec3(0, a, b), Vec3(b, 0, a)}) s.position.push_back(glm::normalize(p));
  // The twenty faces are the triples of corners that are one edge apart; outward by their sum.
  float edge = 2 / std::sqrt(g * g + 1) * 1.01f;
  auto near = [&](std::uint32_t a, std::uint32_t b) {
    return glm::distance(s.position[a], s.position[b]) < edge;
  };
  for (std::uint32_t a = 0; a < 12; ++a)
    for (std::uint32_t b = a + 1; b < 12; ++b)
      for (std::uint32_t c = b + 1; c < 12; ++c) {
        if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
        if (glm::dot(area_of(s, {a, b, c}), s.position[a]) > 0)
          s.triangle.push_back({a, b, c});
        else
          s.triangle.push_back({a, c, b});
      }
  for (int level = 0; level < detail; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    auto middle = [&](std::uint32_t a, std::uint32_t b) {
      auto [place, fresh] = middles.try_emplace(std::pair(std::min(a, b), std::max(a, b)),
                                                static_cast<std::uint32_t>(s.position.size()));
      if (fresh) s.position.push_back(glm::normalize(s.position[a] + s.position[b]));
      return place->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (auto [a, b, c] : s.triangle) {
      auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (auto t : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) finer.push_back(t);
    }
    s.triangle = std::move(finer);
  }
  return s;
}

}  // namespace

Vec3 stone_surface_point(const Stone& stone, Vec3 direction) {
  Vec3 d = glm::normalize(direction);
  Vec3 shift = random_shift(stone.seed);
  double lumps = fractal_noise(d * 0.8f + shift, 2), grain = fractal_noise(d * 2.7f + shift * 1.7f, 2);
  double radius = 0.5 * (1 + stone.roughness * (0.55 * lumps + 0.17 * grain));
  return d * static_cast<float>(radius) * Vec3(1, static_cast<float>(1 - stone.flatness), 1);
}

Surface stone_surface(const Stone& stone, int detail) {
  assert(detail >= 0 && detail <= 6);
  Surface surface = icosphere(detail);
  for (Vec3& p : surface.position) p = stone_surface_point(stone, p);
  set_normals(surface);
  return surface;
}

}  // namespace frond
