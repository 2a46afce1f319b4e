#include "land/far_shapes.h"

#include <cmath>
#include <span>

namespace frond {

namespace {

constexpr float kTrunk = 0, kWall = 0.1f, kRoof = 0.4f, kChimney = 0.6f, kWindow = 0.9f;

void add_far_triangle(Surface& s, std::array<Vec3, 3> at, std::array<Vec3, 3> normal, float u) {
  auto first = static_cast<std::uint32_t>(s.position.size());
  for (std::size_t k = 0; k < 3; ++k) {
    s.position.push_back(at[k]);
    s.normal.push_back(normal[k]);
    s.uv.emplace_back(u, 0);
  }
  s.triangle.push_back({first, first + 1, first + 2});
}

/// Counter-clockwise seen from outside.
void add_far_polygon(Surface& s, std::span<const Vec3> at, float u) {
  Vec3 normal = glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0]));
  for (std::size_t k = 1; k + 1 < at.size(); ++k)
    add_far_triangle(s, {at[0], at[k], at[k + 1]}, {normal, normal, normal}, u);
}

void add_trunk(Surface& s, float radius, float height) {
  constexpr int kSides = 5;
  for (int i = 0; i < kSides; ++i) {
    auto side = [&](int k) {
      double turn = 2 * kPi * k / kSides;
      return Vec3(std::cos(turn), 0, std::sin(turn));
    };
    Vec3 a = side(i), b = side(i + 1), top(0, height, 0);
    add_far_triangle(s, {radius * a, 0.5f * radius * a + top, radius * b}, {a, a, b}, kTrunk);
    add_far_triangle(s, {radius * b, 0.5f * radius * a + top, 0.5f * radius * b + top}, {b, a, b}, kTrunk);
  }
}

Vec3 far_direction(Seed seed) {
  auto y = static_cast<float>(seed.child(0).range(-1, 1));
  double turn = seed.child(1).range(0, 2 * kPi);
  float flat = std::sqrt(1 - y * y);
  return {flat * static_cast<float>(std::cos(turn)), y, flat * static_cast<float>(std::sin(turn))};
}

/// A clump of leaves: `count` triangles of about `size` in a ball that is `flat` times as high as wide; what
/// of it lies low or inside of the crown is darker.
void add_clump(Surface& s, Vec3 middle, float radius, float flat, int count, float size, float light,
               Seed seed) {
  for (int i = 0; i < count; ++i) {
    Seed own = seed.child(static_cast<std::uint64_t>(i));
    Vec3 out = far_direction(own.child("out"));
    auto deep = static_cast<float>(std::cbrt(own.child("deep").range(0.35, 1)));
    Vec3 at = middle + radius * deep * out * Vec3(1, flat, 1);
    // Leaves lie about across the way out, and face as the clump does.
    Vec3 tilted = glm::normalize(out + 0.9f * far_direction(own.child("tilt")));
    Vec3 side = glm::normalize(glm::cross(tilted, Vec3(0.31f, 0.2f, 0.93f)));
    Vec3 up = glm::cross(side, tilted);
    float wide = size * static_cast<float>(own.child("size").range(0.7, 1.4));
    float u = std::clamp(light + 0.35f * (deep - 0.8f) + 0.25f * out.y, 0.1f, 1.0f);
    Vec3 normal = glm::normalize(out + Vec3(0, 0.25f, 0));
    add_far_triangle(
        s, {at + wide * up, at - wide * (0.5f * up + 0.8f * side), at - wide * (0.5f * up - 0.8f * side)},
        {normal, normal, normal}, u);
  }
}

}  // namespace

Surface far_broadleaf(Seed seed) {
  Surface s;
  add_trunk(s, 0.022f, 0.5f);
  constexpr int kClumps = 26;
  double wide = seed.child("wide").range(0.30, 0.40), low = seed.child("low").range(0.10, 0.2);
  for (int i = 0; i < kClumps; ++i) {
    Seed own = seed.child("clump", static_cast<std::uint64_t>(i));
    double share = (i + 0.5) / kClumps, y = 1 - 2 * share, flat = std::sqrt(1 - y * y),
           turn = kGoldenAngle * i;
    double out = i % 4 == 3 ? 0.35 : own.child("out").range(0.62, 0.84);
    Vec3 middle(out * wide * flat * std::cos(turn), 0.5 * (1 + low) + 0.5 * (0.98 - low) * out * y,
                out * wide * flat * std::sin(turn));
    auto radius = static_cast<float>(own.child("radius").range(0.10, 0.17));
    add_clump(s, middle, radius, 0.75f, 58, 0.026f, static_cast<float>(0.5 + 0.3 * y * out),
              own.child("leaves"));
  }
  return s;
}

Surface far_conifer(Seed seed) {
  Surface s;
  add_trunk(s, 0.016f, 0.9f);
  constexpr int kWhorls = 22;
  double wide = seed.child("wide").range(0.15, 0.20);
  for (int w = 0; w < kWhorls; ++w) {
    double share = static_cast<double>(w) / kWhorls, y = 0.07 + 0.93 * share;
    double radius = wide * std::pow(1 - share, 0.85) + 0.006;
    int count = 7 + static_cast<int>(9 * (1 - share));
    for (int i = 0; i < count; ++i) {
      Seed own = seed.child("branch", static_cast<std::uint64_t>(w)).child(static_cast<std::uint64_t>(i));
      double turn = 2 * kPi * (i + own.child(0).range(-0.4, 0.4)) / count + 1.3 * w;
      auto length = static_cast<float>(radius * own.child(1).range(0.7, 1.1));
      Vec3 out(std::cos(turn), 0, std::sin(turn)), side(-out.z, 0, out.x);
      Vec3 root(0, y + 0.02 + own.child(3).range(-0.024, 0.024), 0),
          tip = root + length * out + Vec3(0, -0.45f * length, 0);
      Vec3 normal = glm::normalize(out + Vec3(0, 0.7f, 0));
      float half = 0.42f * length + 0.006f;
      Vec3 middle = root + 0.55f * (tip - root);
      float u = static_cast<float>(0.55 + 0.3 * share + own.child(2).range(-0.15, 0.15));
      add_far_triangle(s, {middle + half * side, tip, middle - half * side}, {normal, normal, normal}, u);
      add_far_triangle(s, {root, middle + half * side, middle - half * side}, {normal, normal, normal},
                       0.5f * u);
      Vec3 under = middle - Vec3(0, 0.35f * length + 0.01f, 0);
      add_far_triangle(s, {middle + 0.6f * half * side, under, tip}, {normal, normal, normal}, 0.4f * u);
    }
  }
  return s;
}

Surface far_hedge(Seed seed) {
  Surface s;
  constexpr int kClumps = 7;
  for (int i = 0; i < kClumps; ++i) {
    Seed own = seed.child("clump", static_cast<std::uint64_t>(i));
    double x = (i + 0.5) / kClumps - 0.5, high = own.child(0).range(0.42, 0.54);
    Vec3 middle(x, high, own.child(1).range(-0.1, 0.1));
    add_clump(s, middle, 0.21f, static_cast<float>(high / 0.21), 46, 0.055f, 0.5f, own);
  }
  return s;
}

namespace {

/// A wall's windows: `count` of them, and with a door the middle one is one. `across` is the way along the
/// wall, of length 1.
void add_windows(Surface& s, Vec3 foot, Vec3 across, Vec3 out, double length, double floors, bool door) {
  auto count = std::max(1, static_cast<int>(length / 2.6));
  for (int floor = 0; floor < static_cast<int>(floors); ++floor)
    for (int i = 0; i < count; ++i) {
      bool is_door = door && floor == 0 && i == count / 2;
      float half = is_door ? 0.5f : 0.55f, low = is_door ? 0 : 0.9f, high = is_door ? 2.1f : 2.2f;
      Vec3 at = foot + across * static_cast<float>(length * ((i + 0.5) / count - 0.5)) + 0.03f * out +
                Vec3(0, 2.7f * static_cast<float>(floor), 0);
      Vec3 up(0, 1, 0);
      std::array<Vec3, 4> pane{at - half * across + low * up, at + half * across + low * up,
                               at + half * across + high * up, at - half * across + high * up};
      add_far_polygon(s, pane, kWindow);
    }
}

}  // namespace

Surface far_house(double long_side, double wide, double eaves, Seed seed) {
  Surface s;
  auto x = static_cast<float>(long_side / 2), z = static_cast<float>(wide / 2), e = static_cast<float>(eaves);
  auto pitch = static_cast<float>(std::tan(radians(seed.child("pitch").range(38, 48))));
  float ridge = e + z * pitch, over = 0.4f, low = -0.8f;
  auto wall = [&](std::initializer_list<Vec3> at) {
    add_far_polygon(s, std::span(at.begin(), at.size()), kWall);
  };
  wall({Vec3(-x, low, z), Vec3(x, low, z), Vec3(x, e, z), Vec3(-x, e, z)});
  wall({Vec3(x, low, -z), Vec3(-x, low, -z), Vec3(-x, e, -z), Vec3(x, e, -z)});
  wall({Vec3(x, low, z), Vec3(x, low, -z), Vec3(x, e, -z), Vec3(x, ridge, 0), Vec3(x, e, z)});
  wall({Vec3(-x, low, -z), Vec3(-x, low, z), Vec3(-x, e, z), Vec3(-x, ridge, 0), Vec3(-x, e, -z)});
  for (float side : {1.0f, -1.0f}) {
    float eave = e - over * pitch, out = side * (z + over), xx = side * (x + over), lift = 0.12f;
    std::array<Vec3, 4> slab{Vec3(-xx, eave + lift, out), Vec3(xx, eave + lift, out),
                             Vec3(xx, ridge + lift, 0), Vec3(-xx, ridge + lift, 0)};
    add_far_polygon(s, slab, kRoof);
  }
  float cx = 0.45f * x, half = 0.35f;
  auto chimney = [&](std::array<Vec3, 4> at) { add_far_polygon(s, at, kChimney); };
  float foot = ridge - 1.2f, top = ridge + 0.9f, cz = 0.5f;
  std::array<Vec2, 4> corner{Vec2(cx - half, cz + half), Vec2(cx + half, cz + half),
                             Vec2(cx + half, cz - half), Vec2(cx - half, cz - half)};
  for (std::size_t k = 0; k < 4; ++k) {
    Vec2 a = corner[k], b = corner[(k + 1) % 4];
    chimney({Vec3(a.x, foot, a.y), Vec3(b.x, foot, b.y), Vec3(b.x, top, b.y), Vec3(a.x, top, a.y)});
  }
  chimney({Vec3(corner[0].x, top, corner[0].y), Vec3(corner[1].x, top, corner[1].y),
           Vec3(corner[2].x, top, corner[2].y), Vec3(corner[3].x, top, corner[3].y)});
  double floors = eaves / 2.6;
  add_windows(s, Vec3(0, 0, z), Vec3(1, 0, 0), Vec3(0, 0, 1), long_side, floors, true);
  add_windows(s, Vec3(0, 0, -z), Vec3(-1, 0, 0), Vec3(0, 0, -1), long_side, floors, false);
  add_windows(s, Vec3(x, 0, 0), Vec3(0, 0, -1), Vec3(1, 0, 0), wide, floors + 1, false);
  add_windows(s, Vec3(-x, 0, 0), Vec3(0, 0, 1), Vec3(-1, 0, 0), wide, floors + 1, false);
  return s;
}

}  // namespace frond
