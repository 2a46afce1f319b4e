#include "land/litter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/noise.h"

namespace frond {

namespace {

constexpr int kOwnNumbers = 64;

/// Numbers by which one thing differs from the next, each of a purpose k.
struct Numbers {
  const Seed& seed;
  float operator()(std::uint64_t k, double low, double high) const {
    return static_cast<float>(seed.child(k).range(low, high));
  }
};

/// u of a place on a thing of such a number; at its ends it is not yet on the next thing.
float own_u(float own, float along) { return own + std::clamp(along, 0.002f, 0.998f); }

/// Where something lies: `along` from foot to tip, `up` its upper side.
struct Lie {
  Vec3 at;
  Vec3 along, across, up;
  float own;  // a whole number
};

Lie lie(const Seed& seed, double side, double tilt) {
  Numbers number{seed};
  float turn = number(0, 0, 2 * kPi), half = static_cast<float>(side / 2);
  float pitch = number(1, -tilt, tilt), roll = number(2, -tilt, tilt);
  Quat rotation = glm::angleAxis(turn, Vec3(0, 1, 0)) * glm::angleAxis(pitch, Vec3(1, 0, 0)) *
                  glm::angleAxis(roll, Vec3(0, 0, 1));
  // The upper side of what has fallen may be below.
  constexpr double kUpsideDown = 0.4;  // share of all
  float face = number(3, 0, 1) < kUpsideDown ? -1.0f : 1.0f;
  return {Vec3(number(4, -half, half), 0, number(5, -half, half)), rotation * Vec3(0, 0, 1),
          rotation * Vec3(face, 0, 0), rotation * Vec3(0, face, 0), std::floor(number(6, 0, kOwnNumbers))};
}

/// A dry leaf: pointed, bent along its midrib, its two halves rolled up or down, its rim wavy.
void add_leaf(Surface& s, const Lie& leaf, float length, const Seed& seed) {
  constexpr std::uint32_t kRows = 7, kPoints = 5;  // rows from foot to tip; points across each between them
  Numbers number{seed};
  float width = length * number(20, 0.24, 0.36), widest = number(24, 0.38, 0.52);
  float bend = number(21, -0.5, 0.7), fold = number(22, -0.15, 0.55), twist = number(23, -0.6, 0.6);
  std::array<float, 2> roll{number(25, -0.4, 1.1), number(26, -0.4, 1.1)};
  float wave = number(27, 0.03, 0.12), phase = number(28, 0, 2 * kPi);
  auto start = static_cast<std::uint32_t>(s.position.size());
  for (std::uint32_t row = 0; row < kRows; ++row) {
    float t = static_cast<float>(row) / (kRows - 1), c = t - 0.5f;
    // The foot is rounder than the tip: there a quarter of an ellipse, here nearly straight.
    float place = t < widest ? t / widest : (1 - t) / (1 - widest);
    float half = width * (t < widest ? std::sqrt(place * (2 - place)) : place * (1.6f - 0.6f * place));
    Vec3 midrib = leaf.at + leaf.along * (c * length) + leaf.up * (-bend * c * c * length);
    bool end = row == 0 || row + 1 == kRows;
    for (std::uint32_t k = 0; k < (end ? 1 : kPoints); ++k) {
      float side = end ? 0 : 2 * static_cast<float>(k) / (kPoints - 1) - 1, out = std::abs(side);
      float rolled = roll[side > 0 ? 1 : 0] * out * out;
      float rise = (fold * out + rolled + twist * c * side) * half +
                   out * out * wave * width * std::sin(9 * t + phase + 2 * side);
      s.position.push_back(midrib + leaf.across * (side * half * (1 - 0.3f * std::abs(rolled))) +
                           leaf.up * rise);
      s.uv.emplace_back(own_u(leaf.own, t), (side + 1) / 2);
    }
  }
  auto at = [&](std::uint32_t row, std::uint32_t k) {
    return row == 0           ? start
           : row + 1 == kRows ? start + 1 + (kRows - 2) * kPoints
                              : start + 1 + (row - 1) * kPoints + k;
  };
  for (std::uint32_t row = 0; row + 1 < kRows; ++row) {
    for (std::uint32_t k = 0; k + 1 < kPoints; ++k) {
      if (row > 0) s.triangle.push_back({at(row, k), at(row + 1, k), at(row, k + 1)});
      if (row + 2 < kRows) s.triangle.push_back({at(row, k + 1), at(row + 1, k), at(row + 1, k + 1)});
    }
  }
}

/// A dead twig of three sides, bent at two places.
void add_twig(Surface& s, const Lie& twig, float length, const Seed& seed) {
  constexpr std::uint32_t kRings = 4, kSides = 3;
  constexpr double kThin = 0.008, kThick = 0.016;  // radius at its foot by its length
  constexpr float kTaper = 0.6f;                   // how much thinner it is at its tip
  constexpr double kBend = 0.35;                   // aside on the way along, at most
  auto start = static_cast<std::uint32_t>(s.position.size());
  float radius = length * static_cast<float>(seed.child(20).range(kThin, kThick));
  Vec3 at = twig.at + twig.along * (-0.5f * length) + Vec3(0, radius, 0);
  for (std::uint32_t i = 0; i < kRings; ++i) {
    float t = static_cast<float>(i) / (kRings - 1), r = radius * (1 - kTaper * t);
    for (std::uint32_t k = 0; k < kSides; ++k) {
      double angle = 2 * kPi * k / kSides;
      s.position.push_back(at + (twig.across * static_cast<float>(std::cos(angle)) +
                                 twig.up * static_cast<float>(std::sin(angle))) *
                                    r);
      s.uv.emplace_back(own_u(kOwnNumbers + twig.own, t), static_cast<float>(k) / kSides);
    }
    float aside = static_cast<float>(seed.child(21 + i).range(-kBend, kBend));
    at += (twig.along + twig.across * aside) * (length / (kRings - 1));
  }
  for (std::uint32_t i = 0; i + 1 < kRings; ++i) {
    for (std::uint32_t k = 0; k < kSides; ++k) {
      std::uint32_t a = start + i * kSides + k, b = start + i * kSides + (k + 1) % kSides;
      s.triangle.push_back({a, a + kSides, b});
      s.triangle.push_back({b, a + kSides, b + kSides});
    }
  }
}

/// Lifts what was added since `first` until no more than `pressed` of it is below the ground.
void lay_on_ground(Surface& s, std::size_t first, float pressed) {
  float lowest = 0;
  for (std::size_t i = first; i < s.position.size(); ++i) lowest = std::min(lowest, s.position[i].y);
  float lift = std::max(-lowest - pressed, 0.0f);
  for (std::size_t i = first; i < s.position.size(); ++i) s.position[i].y += lift;
}

// How far things are tilted as they lie, radians: a leaf by itself, leaves on each other, twigs.
constexpr double kLoneLeafTilt = 0.1, kLeafTilt = 0.45, kTwigTilt = 0.06;

}  // namespace

Surface leaf_surface(double length, Seed seed) {
  constexpr double kPressed = 0.05;  // of its length
  Surface s;
  add_leaf(s, lie(seed, 0, kLoneLeafTilt), static_cast<float>(length), seed);
  lay_on_ground(s, 0, static_cast<float>(kPressed * length));
  set_normals(s);
  return s;
}

Surface litter_surface(const LitterShape& shape, Seed seed) {
  // By the length of a leaf, by eye: how far things are pressed into the ground, how high the lowest leaves
  // lie and how much higher the highest, and twigs.
  constexpr double kPressed = 0.03, kLowestLeaf = 0.05, kHeap = 0.22, kTwigHeight = 0.2;
  Surface s;
  double area = shape.side * shape.side;
  auto pressed = static_cast<float>(kPressed * shape.leaf);
  auto count = static_cast<std::uint64_t>(std::lround(shape.leaves * area));
  for (std::uint64_t i = 0; i < count; ++i) {
    Seed own = seed.child("leaf", i);
    Lie leaf = lie(own, shape.side, kLeafTilt);
    double length = shape.leaf * own.child(10).range(0.6, 1.15);
    // Later ones lie on earlier ones.
    leaf.at.y = static_cast<float>(kLowestLeaf * shape.leaf + kHeap * shape.leaf * own.child(11).unit());
    std::size_t first = s.position.size();
    add_leaf(s, leaf, static_cast<float>(length), own);
    lay_on_ground(s, first, pressed);
  }
  auto twigs = static_cast<std::uint64_t>(std::lround(shape.twigs * area));
  for (std::uint64_t i = 0; i < twigs; ++i) {
    Seed own = seed.child("twig", i);
    Lie twig = lie(own, shape.side, kTwigTilt);
    twig.at.y = static_cast<float>(kTwigHeight * shape.leaf);
    std::size_t first = s.position.size();
    add_twig(s, twig, static_cast<float>(shape.twig * own.child(10).range(0.4, 1.6)), own);
    lay_on_ground(s, first, pressed);
  }
  set_normals(s);
  return s;
}

Surface moss_surface(double side, Seed seed) {
  constexpr double kDensity = 6000;      // shoots on a square metre
  constexpr double kTowardMiddle = 0.6;  // power of the way out: 0.5 would be even
  // Metres: of the cushion in its middle, of what swells on it, and how far its rim is in the ground.
  constexpr double kDome = 0.006, kSwelling = 0.020, kSunkRim = 0.004;
  constexpr float kSwellings = 9;  // on a metre
  constexpr double kSlant = 0.7;   // of a shoot's tip, by its height at most
  // Of the side: how deep the middle of the ball lies whose normals it has, and how far shoots turn them.
  constexpr double kBallDepth = 0.35;
  constexpr float kShootsTilt = 0.2f;
  Surface s;
  auto count = static_cast<std::uint64_t>(kDensity * side * side);
  Vec3 shift(seed.child("x").range(0, 50), 0, seed.child("z").range(0, 50));
  for (std::uint64_t i = 0; i < count; ++i) {
    Seed own = seed.child(i);
    Numbers number{own};
    // Thinner toward the rim.
    double angle = own.child(0).range(0, 2 * kPi), share = std::pow(own.child(1).unit(), kTowardMiddle);
    Vec3 at(std::cos(angle) * share * side / 2, 0, std::sin(angle) * share * side / 2);
    double swell = 0.5 + 0.5 * fractal_noise(at * kSwellings + shift, 2), dome = 1 - share * share;
    at.y = static_cast<float>(dome * (kDome + kSwelling * std::clamp(swell, 0.0, 1.0)) - kSunkRim);
    float height = number(2, 0.008, 0.018), half = number(3, 0.0014, 0.0028), toward = number(4, 0, 2 * kPi);
    Vec3 lean(std::cos(toward), 0, std::sin(toward)), across(-lean.z, 0, lean.x);
    Vec3 tip = at + Vec3(0, height, 0) + lean * (height * number(5, 0, kSlant));
    float v = number(6, 0, 0.6) + static_cast<float>(0.4 * std::clamp(swell, 0.0, 1.0));
    auto a = static_cast<std::uint32_t>(s.position.size());
    // Lit as a cushion rather than as shoots, or it would sparkle.
    Vec3 normal =
        glm::normalize(Vec3(at.x, kBallDepth * side, at.z) + lean * (kShootsTilt * static_cast<float>(side)));
    for (auto [place, u] : {std::pair{at - across * half, 0.0f}, {at + across * half, 0.0f}, {tip, 1.0f}}) {
      s.position.push_back(place);
      s.normal.push_back(normal);
      s.uv.emplace_back(u, v);
    }
    s.triangle.push_back({a, a + 1, a + 2});
  }
  return s;
}

}  // namespace frond
