#include "land/herb.h"

#include <cmath>

#include "core/noise.h"

namespace frond {

namespace {

constexpr int kJoints = 3;  // of a blade, below its tip
constexpr Vec3 kUp(0, 1, 0);

/// v on a plant's part: the number of its kind, and its own between this and the next, at neither end.
template <class Kind>
float coded(Kind kind, float own) {
  constexpr float kFirst = 0.05f, kRange = 0.85f;
  return static_cast<float>(kind) + kFirst + kRange * own;
}

/// Adds corners of one plant to a mesh.
struct Corners {
  Surface& s;
  float v;
  std::uint32_t start = static_cast<std::uint32_t>(s.position.size());

  void add(Vec3 at, Vec3 normal, float u) {
    s.position.push_back(at);
    s.normal.push_back(normal);
    s.uv.emplace_back(u, v);
  }
  void join(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    s.triangle.push_back({start + a, start + b, start + c});
  }
};

/// The axes of what stands at the end of a stalk: up, and two level with it.
struct StalkAxes {
  Vec3 up, x, y;
};

StalkAxes axes_at_end(const BladeOfGrass& b, float lean) {
  Vec3 up = glm::normalize(kUp + b.toward * lean);
  Vec3 x = glm::normalize(glm::cross(up, b.across));
  return {up, x, glm::cross(up, x)};
}

Vec3 round_about(const StalkAxes& s, double angle) {
  return s.x * static_cast<float>(std::cos(angle)) + s.y * static_cast<float>(std::sin(angle));
}

/// The petals or rays of a flower head: points round its rim, three to each of them; how far the rim rises by
/// the radius; and how far its normals lean inward.
struct HeadShape {
  std::uint32_t rim;
  float rise, inward;
};
constexpr HeadShape kFivePetals{15, 0.55f, 0.4f}, kThirteenRays{39, 0.12f, 0};

/// A spindle of three sides along an axis.
void add_spindle(Surface& s, Vec3 foot, Vec3 tip, float radius, float v, float belly) {
  Corners corners{s, v};
  Vec3 axis = glm::normalize(tip - foot);
  Vec3 x = glm::normalize(glm::cross(axis, reference_axis(axis)));
  Vec3 y = glm::cross(axis, x), middle = foot + (tip - foot) * belly;
  corners.add(foot, glm::normalize(kUp - axis), 0);
  for (int i = 0; i < 3; ++i) {
    Vec3 out =
        x * static_cast<float>(std::cos(2 * kPi * i / 3)) + y * static_cast<float>(std::sin(2 * kPi * i / 3));
    corners.add(middle + out * radius, glm::normalize(out + kUp * 0.6f), belly);
  }
  corners.add(tip, glm::normalize(kUp + axis), 1);
  for (std::uint32_t i = 0; i < 3; ++i) {
    corners.join(0, 1 + i, 1 + (i + 1) % 3);
    corners.join(1 + i, 4, 1 + (i + 1) % 3);
  }
}

}  // namespace

void add_blade(Surface& s, const BladeOfGrass& b) {
  Corners corners{s, b.own};
  // Grass is lit as a lawn rather than as blades, or it would sparkle.
  constexpr float kLeaning = 0.35f, kTipLeaning = 0.3f;  // of normals toward where it bends; more at its tip
  constexpr float kRounded = 0.4f;                       // of normals across
  constexpr float kTaper = 0.55f;                        // how much narrower it is at its tip
  Vec3 lawn = kUp + b.toward * kLeaning + b.across * (b.own - 0.5f);
  for (int i = 0; i < kJoints; ++i) {
    float t = static_cast<float>(i) / kJoints, half = 0.5f * b.width * (1 - kTaper * t * t);
    for (float side : {-1.0f, 1.0f})
      corners.add(b.along(t) + b.across * (side * half), glm::normalize(lawn + b.across * (side * kRounded)),
                  t);
  }
  corners.add(b.along(1), glm::normalize(lawn + b.toward * kTipLeaning), 1);
  for (std::uint32_t i = 0; i + 1 < kJoints; ++i) {
    corners.join(2 * i, 2 * i + 1, 2 * i + 3);
    corners.join(2 * i, 2 * i + 3, 2 * i + 2);
  }
  corners.join(2 * kJoints - 2, 2 * kJoints - 1, 2 * kJoints);
}

void add_trefoil(Surface& s, const BladeOfGrass& stalk, float length, HerbPart kind) {
  // Half a leaflet, from its foot round to its notched end, and how far along it each corner is.
  constexpr Vec2 kRim[] = {{0.42f, 0.33f}, {0.88f, 0.30f}};
  constexpr float kMiddle = 0.55f, kNotch = 0.93f;  // places along its midrib
  constexpr float kFolded = 0.35f, kHanging = 0.22f;
  constexpr float kChevron = 0.55f;  // slope of u across, which bends the pale mark
  StalkAxes axes = axes_at_end(stalk, 0.15f + 0.3f * stalk.own);
  Vec3 foot = stalk.along(1);
  for (int leaflet = 0; leaflet < 3; ++leaflet) {
    Corners corners{s, coded(kind, stalk.own)};
    Vec3 out = round_about(axes, 2 * kPi * leaflet / 3 + 6 * stalk.own);
    Vec3 aside = glm::cross(axes.up, out), rise = axes.up * (0.28f - 0.35f * stalk.own);
    auto add = [&](float along, float across) {
      // Folded along its midrib, and hanging at its end.
      Vec3 at = foot + (out * along + aside * across + rise * along +
                        axes.up * (kFolded * std::abs(across) - kHanging * along * along)) *
                           length;
      corners.add(at, glm::normalize(axes.up + out * 0.25f - aside * (0.9f * across)),
                  along + kChevron * std::abs(across));
    };
    add(0, 0), add(kMiddle, 0), add(kNotch, 0);
    for (Vec2 rim : kRim) add(rim.x, rim.y), add(rim.x, -rim.y);
    for (std::uint32_t side = 0; side < 2; ++side) {
      std::uint32_t low = 3 + side, high = 5 + side;
      corners.join(0, low, 1);
      corners.join(low, high, 1);
      corners.join(high, 2, 1);
    }
  }
}

void add_rosette_leaf(Surface& s, const BladeOfGrass& b, float rise) {
  constexpr Vec2 kShape[] = {{0.0f, 0.10f}, {0.35f, 0.55f}, {0.7f, 1.0f}};  // along, and how wide it is there
  constexpr float kTrough = 0.2f;  // by the width: how far its edges rise
  Corners corners{s, coded(HerbPart::herb, b.own)};
  Vec3 out = glm::normalize(b.toward + kUp * rise), up = glm::normalize(glm::cross(b.across, out));
  if (up.y < 0) up = -up;
  auto place = [&](float t) { return b.root + out * (b.length * t) - kUp * (b.droop * b.length * t * t); };
  for (Vec2 at : kShape)
    for (float side : {-1.0f, 0.0f, 1.0f})
      corners.add(place(at.x) + b.across * (side * 0.5f * b.width * at.y) +
                      up * (kTrough * std::abs(side) * b.width * at.y),
                  glm::normalize(up + kUp - b.across * (0.5f * side)), at.x + 0.25f * std::abs(side));
  corners.add(place(1), glm::normalize(up + kUp), 1);
  for (std::uint32_t i = 0; i < 2; ++i)
    for (std::uint32_t k = 0; k < 2; ++k) {
      std::uint32_t a = 3 * i + k;
      corners.join(a, a + 1, a + 4);
      corners.join(a, a + 4, a + 3);
    }
  corners.join(6, 7, 9);
  corners.join(7, 8, 9);
}

void add_head(Surface& s, const BladeOfGrass& stalk, float radius, Bloom kind) {
  Corners corners{s, coded(kind, stalk.own)};
  constexpr float kBetween = 0.62f;  // radius between two of them, by that at their ends
  const auto [rim, rise, inward] = kind == Bloom::buttercup ? kFivePetals : kThirteenRays;
  StalkAxes axes = axes_at_end(stalk, 0.3f + 0.5f * stalk.own);
  Vec3 centre = stalk.along(1);
  corners.add(centre, axes.up, 0);
  for (std::uint32_t i = 0; i < rim; ++i) {
    float r = radius * (i % 3 ? 1.0f : kBetween);
    Vec3 out = round_about(axes, 2 * kPi * i / rim);
    corners.add(centre + out * r + axes.up * (r * rise), glm::normalize(axes.up - out * inward), 1);
  }
  for (std::uint32_t i = 0; i < rim; ++i) corners.join(0, 1 + i, 1 + (i + 1) % rim);
}

void add_clover_head(Surface& s, const BladeOfGrass& stalk, float radius) {
  // Rings of florets, each pointing outward from the ball and the lowest hanging.
  constexpr int kRings = 3, kFlorets = 9;
  constexpr float kLowest = -0.45f, kApart = 0.62f;  // rise over run, of the lowest and between rings
  StalkAxes axes = axes_at_end(stalk, 0.15f);
  Vec3 centre = stalk.along(1) + axes.up * (0.4f * radius);
  for (int ring = 0; ring < kRings; ++ring) {
    float lift = kLowest + kApart * static_cast<float>(ring);
    for (int i = 0; i < kFlorets - 2 * ring; ++i) {
      Corners corners{s, coded(Bloom::clover, stalk.own)};
      double angle = 2 * kPi * (i + 0.5 * (ring % 2)) / (kFlorets - 2 * ring);
      Vec3 out = glm::normalize(round_about(axes, angle) + axes.up * lift),
           aside = glm::normalize(glm::cross(axes.up, out));
      Vec3 over = glm::cross(out, aside);
      corners.add(centre + out * (0.25f * radius), out, 0);
      corners.add(centre + out * (0.8f * radius) + aside * (0.36f * radius), out, 0.6f);
      corners.add(centre + out * (1.05f * radius) + over * (0.15f * radius), out, 1);
      corners.add(centre + out * (0.8f * radius) - aside * (0.36f * radius), out, 0.6f);
      corners.join(0, 1, 2);
      corners.join(0, 2, 3);
    }
  }
}

void add_spike(Surface& s, const BladeOfGrass& stalk, float length) {
  constexpr float kThick = 0.17f, kBelly = 0.35f;  // radius by the length, and where it is thickest
  Vec3 tip = stalk.along(1), direction = glm::normalize(tip - stalk.along(0.9f));
  add_spindle(s, tip, tip + direction * length, kThick * length, coded(Bloom::spike, stalk.own), kBelly);
}

void add_panicle(Surface& s, const BladeOfGrass& stalk, float length) {
  constexpr int kSpikelets = 7;
  constexpr double kTurn = 2.4;                       // radians from one to the next: the golden angle
  constexpr float kLength = 0.42f, kShorter = 0.16f;  // by the panicle's: of the lowest, less of the highest
  constexpr float kThick = 0.11f, kBelly = 0.6f;      // radius by the length, and where it is thickest
  constexpr float kSpread = 0.42f, kClosing = 0.75f;  // of the lowest, and how much less of the highest
  float share = length / stalk.length;
  for (int i = 0; i < kSpikelets; ++i) {
    float t = static_cast<float>(i) / (kSpikelets - 1), spread = kSpread * (1 - kClosing * t);
    double angle = kTurn * i + 6 * stalk.own;
    Vec3 out = stalk.across * static_cast<float>(std::cos(angle)) +
               stalk.toward * static_cast<float>(std::sin(angle));
    Vec3 foot = stalk.along(1 - share * (1 - t)), direction = out * spread + kUp * (0.55f - 0.25f * spread);
    float size = length * (kLength - kShorter * t);
    add_spindle(s, foot + direction * (0.15f * size), foot + direction * size, kThick * size,
                coded(Bloom::panicle, stalk.own), kBelly);
  }
}

void add_earth(Surface& s, float radius, float own) {
  constexpr std::uint32_t kRim = 20;
  constexpr float kMiddleHeight = 0.03f, kRingHeight = 0.02f, kRimDepth = -0.08f;  // by the radius
  Corners corners{s, coded(HerbPart::earth, own)};
  corners.add(Vec3(0, kMiddleHeight * radius, 0), kUp, 0);
  for (float ring : {0.75f, 1.0f}) {
    for (std::uint32_t i = 0; i < kRim; ++i) {
      double angle = 2 * kPi * i / kRim;
      Vec3 out(std::cos(angle), 0, std::sin(angle));
      float r = radius * ring * earth_reach(out, own);
      corners.add(out * r + kUp * (ring < 1 ? kRingHeight * radius : kRimDepth * radius), kUp, ring);
    }
  }
  for (std::uint32_t i = 0; i < kRim; ++i) {
    std::uint32_t a = 1 + i, b = 1 + (i + 1) % kRim;
    corners.join(0, b, a);
    corners.join(a, b, a + kRim);
    corners.join(b, b + kRim, a + kRim);
  }
}

float earth_reach(Vec3 out, float own) {
  constexpr float kUneven = 0.35f, kOften = 1.1f;  // share of the radius; waves of noise on a radian
  return 1 + kUneven * static_cast<float>(noise(out * kOften + Vec3(40 * own, 0, 0)));
}

}  // namespace frond
