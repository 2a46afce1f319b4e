#include "land/turf.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

constexpr int kJoints = 3;  // of a blade, below its tip
constexpr int kRays = 10;   // of a flower head

struct BladeOfGrass {
  Vec3 root;
  Vec3 toward, across;  // where it hangs, and the way it is wide
  float length, droop, width, own;
};

Vec3 along(const BladeOfGrass& b, float t) {
  float reach = b.length * b.droop * t * t, height = b.length * t * (1 - 0.45f * b.droop * t);
  return b.root + b.toward * reach + Vec3(0, height, 0);
}

void add_blade(Surface& s, const BladeOfGrass& b) {
  auto start = static_cast<std::uint32_t>(s.position.size());
  // Grass is lit as a lawn rather than as blades, or it would sparkle.
  Vec3 normal = glm::normalize(Vec3(0, 1, 0) + b.toward * 0.35f + b.across * (b.own - 0.5f));
  auto add = [&](Vec3 at, float t) {
    s.position.push_back(at);
    s.normal.push_back(normal);
    s.uv.emplace_back(t, b.own);
  };
  for (int i = 0; i < kJoints; ++i) {
    float t = static_cast<float>(i) / kJoints, half = 0.5f * b.width * (1 - 0.55f * t * t);
    add(along(b, t) - b.across * half, t);
    add(along(b, t) + b.across * half, t);
  }
  add(along(b, 1), 1);
  for (std::uint32_t i = 0; i + 1 < kJoints; ++i) {
    std::uint32_t a = start + 2 * i;
    s.triangle.push_back({a, a + 1, a + 3});
    s.triangle.push_back({a, a + 3, a + 2});
  }
  std::uint32_t last = start + 2 * (kJoints - 1);
  s.triangle.push_back({last, last + 1, last + 2});
}

void add_flower(Surface& s, const BladeOfGrass& b, float radius) {
  auto start = static_cast<std::uint32_t>(s.position.size());
  Vec3 centre = along(b, 1), up = glm::normalize(Vec3(0, 1, 0) + b.toward * (0.3f + 0.5f * b.own));
  Vec3 x = glm::normalize(glm::cross(up, b.across)), y = glm::cross(up, x);
  auto add = [&](Vec3 at, float u) {
    s.position.push_back(at);
    s.normal.push_back(up);
    s.uv.emplace_back(u, b.own);
  };
  add(centre, 0);
  for (int i = 0; i < 2 * kRays; ++i) {
    double angle = kPi * i / kRays;
    float r = radius * (i % 2 ? 0.72f : 1.0f);
    add(centre + (x * static_cast<float>(std::cos(angle)) + y * static_cast<float>(std::sin(angle))) * r +
            up * (r * 0.12f),
        1);
  }
  for (std::uint32_t i = 0; i < 2 * kRays; ++i)
    s.triangle.push_back({start, start + 1 + i, start + 1 + (i + 1) % (2 * kRays)});
}

}  // namespace

Turf turf_surface(const TurfShape& shape, Seed seed) {
  Turf turf;
  auto count = static_cast<std::uint64_t>(std::max(0.0, shape.density * shape.side * shape.side));
  for (std::uint64_t i = 0; i < count; ++i) {
    Seed own = seed.child(i);
    auto number = [&](std::uint64_t k, double low, double high) {
      return static_cast<float>(own.child(k).range(low, high));
    };
    float angle = number(0, 0, 2 * kPi), side = static_cast<float>(shape.side / 2);
    BladeOfGrass blade;
    blade.root = Vec3(number(1, -side, side), 0, number(2, -side, side));
    blade.toward = Vec3(std::cos(angle), 0, std::sin(angle));
    blade.across = Vec3(-blade.toward.z, 0, blade.toward.x);
    blade.own = number(3, 0, 1);
    blade.length = static_cast<float>(shape.blade) * number(4, 0.45, 1.15);
    blade.droop = number(5, 0.1, 0.75);
    blade.width = static_cast<float>(shape.blade) * number(6, 0.035, 0.07);
    if (own.child(7).unit() < shape.flowers) {
      blade.droop *= 0.25f;
      blade.length = static_cast<float>(shape.blade) * number(4, 0.8, 1.25);
      blade.width *= 0.5f;
      add_flower(turf.flowers, blade, static_cast<float>(shape.blade) * number(8, 0.09, 0.14));
    }
    add_blade(turf.blades, blade);
  }
  return turf;
}

}  // namespace frond
