#include "draw/surfel_sampler.h"

namespace frond {

namespace {

/// What is hidden, seen from far away in a direction.
double shade_of(const std::vector<std::array<Vec3, 3>>& triangles, Vec3 direction) {
  constexpr int kSide = 96;
  Eye eye = eye_toward(Vec3(0), direction, 1, 1, 1);
  Vec3 aside = glm::cross(eye.ahead, eye.up);
  auto flat = [&](Vec3 p) { return Vec2(glm::dot(p, aside), glm::dot(p, eye.up)); };
  Vec2 low(1e30f), high(-1e30f);
  for (const auto& triangle : triangles)
    for (const Vec3& p : triangle) low = glm::min(low, flat(p)), high = glm::max(high, flat(p));
  Vec2 pixel = (high - low) / static_cast<float>(kSide);
  if (!(pixel.x > 0 && pixel.y > 0)) return 0;
  std::vector<char> hidden(kSide * kSide, 0);
  for (const auto& triangle : triangles) {
    std::array<Vec2, 3> p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = (flat(triangle[c]) - low) / pixel - 0.5f;
    auto first = glm::ivec2(glm::max(glm::ceil(glm::min(p[0], glm::min(p[1], p[2]))), Vec2(0)));
    auto last = glm::ivec2(glm::min(glm::max(p[0], glm::max(p[1], p[2])), Vec2(kSide - 1)));
    auto side = [](Vec2 a, Vec2 b, Vec2 at) {
      return (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
    };
    for (int row = first.y; row <= last.y; ++row) {
      for (int column = first.x; column <= last.x; ++column) {
        Vec2 at(column, row);
        float a = side(p[0], p[1], at), b = side(p[1], p[2], at), c = side(p[2], p[0], at);
        if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0))
          hidden[static_cast<std::size_t>(row * kSide + column)] = 1;
      }
    }
  }
  return static_cast<double>(std::ranges::count(hidden, 1)) * pixel.x * pixel.y;
}

}  // namespace

float apart_area(const std::vector<std::array<Vec3, 3>>& triangles) {
  constexpr int kWays = 7;
  double sum = 0;
  for (int k = 0; k < kWays; ++k) {
    double y = (k + 0.5) / kWays, r = std::sqrt(1 - y * y), turn = kGoldenAngle * k;
    sum += shade_of(triangles, Vec3(r * std::cos(turn), y, r * std::sin(turn)));
  }
  return static_cast<float>(2 * sum / kWays);
}

}  // namespace frond
