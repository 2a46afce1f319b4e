#include "land/far_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace frond {

namespace {

// u of each part, as the header says. All shapes below are by eye; trees and hedges in shares of their
// height.
constexpr float kTrunk = 0, kInnermostLeaf = 0.1f, kOutermostLeaf = 1;
constexpr float kWall = 0.1f, kRoof = 0.4f, kChimney = 0.6f, kWindow = 0.9f;

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
  constexpr float kTaper = 0.5f;  // radius at the top by that at the foot
  for (int i = 0; i < kSides; ++i) {
    auto side = [&](int k) {
      double turn = 2 * kPi * k / kSides;
      return Vec3(std::cos(turn), 0, std::sin(turn));
    };
    Vec3 a = side(i), b = side(i + 1), top(0, height, 0);
    add_far_triangle(s, {radius * a, kTaper * radius * a + top, radius * b}, {a, a, b}, kTrunk);
    add_far_triangle(s, {radius * b, kTaper * radius * a + top, kTaper * radius * b + top}, {b, a, b},
                     kTrunk);
  }
}

Vec3 far_direction(Seed seed) {
  auto y = static_cast<float>(seed.child(0).range(-1, 1));
  double turn = seed.child(1).range(0, 2 * kPi);
  float flat = std::sqrt(1 - y * y);
  return {flat * static_cast<float>(std::cos(turn)), y, flat * static_cast<float>(std::sin(turn))};
}

/// A clump of leaves: `count` triangles of about `size` in a ball that is `flat` times as high as wide, and
/// how light it is: u in its middle.
struct Clump {
  Vec3 middle;
  float radius, flat;
  int count;
  float size, light;
};

/// What of it lies low or inside of the crown is darker.
void add_clump(Surface& s, const Clump& clump, Seed seed) {
  constexpr double kInside = 0.35;  // share of the ball's volume in its middle that is empty
  constexpr float kTilt = 0.9f;     // of leaves against the way out, 0 none
  constexpr float kByDepth = 0.35f, kByHeight = 0.25f;  // how much lighter it is out and up
  constexpr float kMeanDepth = 0.8f;                    // share of the radius, where it is as light as said
  constexpr float kTowardSky = 0.25f;                   // of the way in which leaves face
  constexpr Vec3 kAskew(0.31f, 0.2f, 0.93f);            // a direction that few leaves face
  for (int i = 0; i < clump.count; ++i) {
    Seed own = seed.child(static_cast<std::uint64_t>(i));
    Vec3 out = far_direction(own.child("out"));
    auto deep = static_cast<float>(std::cbrt(own.child("deep").range(kInside, 1)));
    Vec3 at = clump.middle + clump.radius * deep * out * Vec3(1, clump.flat, 1);
    // Leaves lie about across the way out, and face as the clump does.
    Vec3 tilted = glm::normalize(out + kTilt * far_direction(own.child("tilt")));
    Vec3 side = glm::normalize(glm::cross(tilted, kAskew));
    Vec3 up = glm::cross(side, tilted);
    float wide = clump.size * static_cast<float>(own.child("size").range(0.7, 1.4));
    float u = std::clamp(clump.light + kByDepth * (deep - kMeanDepth) + kByHeight * out.y, kInnermostLeaf,
                         kOutermostLeaf);
    Vec3 normal = glm::normalize(out + Vec3(0, kTowardSky, 0));
    add_far_triangle(
        s, {at + wide * up, at - wide * (0.5f * up + 0.8f * side), at - wide * (0.5f * up - 0.8f * side)},
        {normal, normal, normal}, u);
  }
}

// A house, in metres.
constexpr double kWindowSpacing = 2.6;  // from middle to middle, about
constexpr double kWallAFloor = 2.6;     // height of walls that makes one floor more
constexpr float kFloorHeight = 2.7f;    // from floor to floor, where windows are put
constexpr float kEavesOver = 0.4f;      // how far the roof juts out
constexpr float kFooting = -0.8f;       // to which walls go down, so that none floats on a slope
constexpr float kTiles = 0.12f;         // from the top of the walls to that of the roof

/// What is open in a wall: half its width, and its lower and upper edge above the floor.
struct Opening {
  float half, low, high;
};
constexpr Opening kDoorOpening{0.5f, 0, 2.1f}, kWindowOpening{0.55f, 0.9f, 2.2f};

/// A wall's windows: `count` of them, and with a door the middle one is one. `across` is the way along the
/// wall, of length 1.
void add_windows(Surface& s, Vec3 foot, Vec3 across, Vec3 out, double length, double floors, bool door) {
  auto count = std::max(1, static_cast<int>(length / kWindowSpacing));
  for (int floor = 0; floor < static_cast<int>(floors); ++floor)
    for (int i = 0; i < count; ++i) {
      bool is_door = door && floor == 0 && i == count / 2;
      auto [half, low, high] = is_door ? kDoorOpening : kWindowOpening;
      // A little before the wall, or the two would be one face.
      Vec3 at = foot + across * static_cast<float>(length * ((i + 0.5) / count - 0.5)) + 0.03f * out +
                Vec3(0, kFloorHeight * static_cast<float>(floor), 0);
      Vec3 up(0, 1, 0);
      std::array<Vec3, 4> pane{at - half * across + low * up, at + half * across + low * up,
                               at + half * across + high * up, at - half * across + high * up};
      add_far_polygon(s, pane, kWindow);
    }
}

}  // namespace

Surface far_broadleaf(Seed seed) {
  Surface s;
  constexpr int kClumps = 26;
  constexpr float kTrunkRadius = 0.022f, kTrunkHeight = 0.5f;
  constexpr double kCrownTop = 0.98;
  constexpr double kInnerShare = 0.35;  // of the way out: every fourth clump fills the middle
  add_trunk(s, kTrunkRadius, kTrunkHeight);
  double wide = seed.child("wide").range(0.30, 0.40), low = seed.child("low").range(0.10, 0.2);
  for (int i = 0; i < kClumps; ++i) {
    Seed own = seed.child("clump", static_cast<std::uint64_t>(i));
    double share = (i + 0.5) / kClumps, y = 1 - 2 * share, flat = std::sqrt(1 - y * y),
           turn = kGoldenAngle * i;
    double out = i % 4 == 3 ? kInnerShare : own.child("out").range(0.62, 0.84);
    Vec3 middle(out * wide * flat * std::cos(turn), 0.5 * (1 + low) + 0.5 * (kCrownTop - low) * out * y,
                out * wide * flat * std::sin(turn));
    auto radius = static_cast<float>(own.child("radius").range(0.10, 0.17));
    auto light = static_cast<float>(0.5 + 0.3 * y * out);
    add_clump(
        s, {.middle = middle, .radius = radius, .flat = 0.75f, .count = 58, .size = 0.026f, .light = light},
        own.child("leaves"));
  }
  return s;
}

Surface far_conifer(Seed seed) {
  Surface s;
  constexpr int kWhorls = 22;
  constexpr float kTrunkRadius = 0.016f, kTrunkHeight = 0.9f;
  constexpr double kLowest = 0.07,
                   kCrownHeight = 0.93;         // height of the lowest whorl, and from there to the top
  constexpr double kBulge = 0.85;               // power by which the crown narrows: of a cone 1
  constexpr double kLeader = 0.006;             // radius of the crown at its top
  constexpr int kBranches = 7, kMoreBelow = 9;  // of a whorl at the top, and at the foot so many more
  constexpr double kWhorlTurn = 1.3;            // radians from one whorl to the next
  // By the length of a branch: how far its tip hangs down, half its width, where it is widest, and how deep
  // its twigs hang.
  constexpr float kDroop = 0.45f, kHalfWidth = 0.42f, kWidestAt = 0.55f, kHanging = 0.35f;
  constexpr float kTowardSky = 0.7f;                       // of the way in which needles face
  constexpr float kInnerLight = 0.5f, kUnderLight = 0.4f;  // of a branch's foot and underside, by its end
  add_trunk(s, kTrunkRadius, kTrunkHeight);
  double wide = seed.child("wide").range(0.15, 0.20);
  for (int w = 0; w < kWhorls; ++w) {
    double share = static_cast<double>(w) / kWhorls, y = kLowest + kCrownHeight * share;
    double radius = wide * std::pow(1 - share, kBulge) + kLeader;
    int count = kBranches + static_cast<int>(kMoreBelow * (1 - share));
    for (int i = 0; i < count; ++i) {
      Seed own = seed.child("branch", static_cast<std::uint64_t>(w)).child(static_cast<std::uint64_t>(i));
      double turn = 2 * kPi * (i + own.child(0).range(-0.4, 0.4)) / count + kWhorlTurn * w;
      auto length = static_cast<float>(radius * own.child(1).range(0.7, 1.1));
      Vec3 out(std::cos(turn), 0, std::sin(turn)), side(-out.z, 0, out.x);
      Vec3 root(0, y + 0.02 + own.child(3).range(-0.024, 0.024), 0),
          tip = root + length * out + Vec3(0, -kDroop * length, 0);
      Vec3 normal = glm::normalize(out + Vec3(0, kTowardSky, 0));
      float half = kHalfWidth * length + 0.006f;
      Vec3 middle = root + kWidestAt * (tip - root);
      float u = static_cast<float>(0.55 + 0.3 * share + own.child(2).range(-0.15, 0.15));
      add_far_triangle(s, {middle + half * side, tip, middle - half * side}, {normal, normal, normal}, u);
      add_far_triangle(s, {root, middle + half * side, middle - half * side}, {normal, normal, normal},
                       kInnerLight * u);
      Vec3 under = middle - Vec3(0, kHanging * length + 0.01f, 0);
      add_far_triangle(s, {middle + 0.6f * half * side, under, tip}, {normal, normal, normal},
                       kUnderLight * u);
    }
  }
  return s;
}

Surface far_hedge(Seed seed) {
  Surface s;
  constexpr int kClumps = 7;
  constexpr double kHalfThick = 0.21;
  for (int i = 0; i < kClumps; ++i) {
    Seed own = seed.child("clump", static_cast<std::uint64_t>(i));
    double x = (i + 0.5) / kClumps - 0.5, high = own.child(0).range(0.42, 0.54);
    Vec3 middle(x, high, own.child(1).range(-0.1, 0.1));
    auto radius = static_cast<float>(kHalfThick), flat = static_cast<float>(high / kHalfThick);
    add_clump(s,
              {.middle = middle, .radius = radius, .flat = flat, .count = 46, .size = 0.055f, .light = 0.5f},
              own);
  }
  return s;
}

Surface far_house(double long_side, double wide, double eaves, Seed seed) {
  Surface s;
  auto x = static_cast<float>(long_side / 2), z = static_cast<float>(wide / 2), e = static_cast<float>(eaves);
  auto pitch = static_cast<float>(std::tan(radians(seed.child("pitch").range(38, 48))));
  float ridge = e + z * pitch, over = kEavesOver, low = kFooting;
  auto wall = [&](std::initializer_list<Vec3> at) {
    add_far_polygon(s, std::span(at.begin(), at.size()), kWall);
  };
  wall({Vec3(-x, low, z), Vec3(x, low, z), Vec3(x, e, z), Vec3(-x, e, z)});
  wall({Vec3(x, low, -z), Vec3(-x, low, -z), Vec3(-x, e, -z), Vec3(x, e, -z)});
  wall({Vec3(x, low, z), Vec3(x, low, -z), Vec3(x, e, -z), Vec3(x, ridge, 0), Vec3(x, e, z)});
  wall({Vec3(-x, low, -z), Vec3(-x, low, z), Vec3(-x, e, z), Vec3(-x, ridge, 0), Vec3(-x, e, -z)});
  for (float side : {1.0f, -1.0f}) {
    float eave = e - over * pitch, out = side * (z + over), xx = side * (x + over), lift = kTiles;
    std::array<Vec3, 4> slab{Vec3(-xx, eave + lift, out), Vec3(xx, eave + lift, out),
                             Vec3(xx, ridge + lift, 0), Vec3(-xx, ridge + lift, 0)};
    add_far_polygon(s, slab, kRoof);
  }
  constexpr float kHalfChimney = 0.35f, kBelowRidge = 1.2f, kAboveRidge = 0.9f;  // metres
  float cx = 0.45f * x, half = kHalfChimney;
  auto chimney = [&](std::array<Vec3, 4> at) { add_far_polygon(s, at, kChimney); };
  float foot = ridge - kBelowRidge, top = ridge + kAboveRidge, cz = 0.5f;
  std::array<Vec2, 4> corner{Vec2(cx - half, cz + half), Vec2(cx + half, cz + half),
                             Vec2(cx + half, cz - half), Vec2(cx - half, cz - half)};
  for (std::size_t k = 0; k < 4; ++k) {
    Vec2 a = corner[k], b = corner[(k + 1) % 4];
    chimney({Vec3(a.x, foot, a.y), Vec3(b.x, foot, b.y), Vec3(b.x, top, b.y), Vec3(a.x, top, a.y)});
  }
  chimney({Vec3(corner[0].x, top, corner[0].y), Vec3(corner[1].x, top, corner[1].y),
           Vec3(corner[2].x, top, corner[2].y), Vec3(corner[3].x, top, corner[3].y)});
  double floors = eaves / kWallAFloor;
  add_windows(s, Vec3(0, 0, z), Vec3(1, 0, 0), Vec3(0, 0, 1), long_side, floors, true);
  add_windows(s, Vec3(0, 0, -z), Vec3(-1, 0, 0), Vec3(0, 0, -1), long_side, floors, false);
  add_windows(s, Vec3(x, 0, 0), Vec3(0, 0, -1), Vec3(1, 0, 0), wide, floors + 1, false);
  add_windows(s, Vec3(-x, 0, 0), Vec3(0, 0, 1), Vec3(-1, 0, 0), wide, floors + 1, false);
  return s;
}

}  // namespace frond
