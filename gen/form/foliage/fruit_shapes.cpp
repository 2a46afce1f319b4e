#include "foliage/fruit_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/bounds.h"
#include "foliage/organ_shapes.h"

namespace frond {

namespace {

/// A closed body about +y: `outline(t)` gives radius and height at t, 0 foot .. 1 tip, and `relief(t, turn)`
/// a factor of the radius there. Its poles and rings have each vertex once.
template <class Outline, class Relief>
Surface closed_body(int rows, int sides, const Outline& outline, const Relief& relief) {
  Surface s;
  auto n = static_cast<std::uint32_t>(sides), last = static_cast<std::uint32_t>(1 + rows * sides);
  s.position.emplace_back(0, outline(0.0).y, 0);
  for (int i = 1; i <= rows; ++i) {
    const double t = static_cast<double>(i) / (rows + 1);
    const Vec2 at = outline(t);
    for (int k = 0; k < sides; ++k) {
      const double turn = 2 * kPi * k / sides;
      const float r = at.x * static_cast<float>(relief(t, turn));
      s.position.emplace_back(r * static_cast<float>(std::cos(turn)), at.y,
                              -r * static_cast<float>(std::sin(turn)));
    }
  }
  s.position.emplace_back(0, outline(1.0).y, 0);
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    s.triangle.push_back({0, 1 + next, 1 + k});
    for (std::uint32_t row = 1; row + n < last; row += n)
      add_quad(s, row + k, row + next, row + n + next, row + n + k);
    s.triangle.push_back({last - n + k, last - n + next, last});
  }
  set_normals(s);
  return s;
}

double smooth_body(double, double) { return 1; }

/// Half a circle from the foot, stretched: radius and height at t.
Vec2 half_circle(double t, double width) {
  return {static_cast<float>(0.5 * width * std::sin(kPi * t)),
          static_cast<float>(0.5 - 0.5 * std::cos(kPi * t))};
}

/// With a hollow round the stalk, whose bottom is the origin.
Surface round_body(double width) {
  constexpr double kHollow = 0.07, kHollowWide = 0.11;  // of its length
  return closed_body(
      13, 20,
      [&](double t) {
        Vec2 at = half_circle(t, width);
        const double out = static_cast<double>(at.x) / kHollowWide;
        if (t < 0.5) at.y += static_cast<float>(kHollow * std::exp(-out * out));
        return at - Vec2(0, kHollow);
      },
      smooth_body);
}

Surface drop_body(double width) {
  constexpr double kNeck = 0.5;  // of the width that half a circle has there
  return closed_body(
      13, 20,
      [&](double t) {
        Vec2 at = half_circle(t, width);
        at.x *= static_cast<float>(kNeck + (1 - kNeck) * smooth_step(0.15, 0.7, static_cast<double>(at.y)));
        return at;
      },
      smooth_body);
}

Surface pod_body(double width) {
  constexpr double kBlunt = 0.4;  // power: 1 an ellipsoid, 0 a cylinder
  return closed_body(
      11, 12,
      [&](double t) {
        const Vec2 at = half_circle(t, width);
        return Vec2(0.5 * width * std::pow(std::sin(kPi * t), kBlunt), at.y);
      },
      smooth_body);
}

/// Scales in rows, each between two of the row below, whose ends stand off toward the tip.
Surface cone_body(double width) {
  constexpr int kRows = 12, kAround = 7, kRowPoints = 4, kSidePoints = 4;
  constexpr double kWidestLow = 0.8;            // power of the height: below the middle
  constexpr double kCore = 0.74, kEdge = 0.32;  // of the radius, between scales and at their ends
  return closed_body(
      kRows * kRowPoints, kAround * kSidePoints,
      [&](double t) {
        return Vec2(0.5 * width * std::sin(kPi * std::pow(t, kWidestLow)), static_cast<float>(t));
      },
      [&](double t, double turn) {
        const double row = std::floor(t * kRows), up = t * kRows - row;
        const double across = 2 * std::abs(glm::fract(turn * kAround / (2 * kPi) + 0.5 * row) - 0.5);
        return kCore + kEdge * up * (1 - across * across);
      });
}

/// A capsule with spines all over.
Surface spiny_body(double width) {
  constexpr int kSpines = 90;
  constexpr float kBody = 0.8f, kFoot = 0.035f;  // of its length
  Surface s = closed_body(
      8, 14, [&](double t) { return half_circle(t, width); }, smooth_body);
  for (Vec3& p : s.position) p = (p - Vec3(0, 0.5f, 0)) * kBody + Vec3(0, 0.5f, 0);
  const Vec3 middle(0, 0.5f, 0), wide(0.5 * width, 0.5f, 0.5 * width);
  for (int i = 0; i < kSpines; ++i) {
    const double y = 1 - 2 * (i + 0.5) / kSpines, turn = i * kGoldenAngle, r = std::sqrt(1 - y * y);
    const Vec3 out(r * std::cos(turn), y, r * std::sin(turn));
    const Vec3 side = glm::normalize(glm::cross(out, Vec3(0.3f, 0.2f, 0.9f))), other = glm::cross(out, side);
    const auto first = static_cast<std::uint32_t>(s.position.size());
    for (int k = 0; k < 3; ++k) {
      const auto around = static_cast<float>(2 * kPi * k / 3);
      s.position.push_back(middle + kBody * 0.97f * wide * out +
                           kFoot * (std::cos(around) * side + std::sin(around) * other));
    }
    s.position.push_back(middle + wide * out);
    for (std::uint32_t k = 0; k < 3; ++k) s.triangle.push_back({first + k, first + (k + 1) % 3, first + 3});
  }
  set_normals(s);
  return s;
}

constexpr double kCupHigh = 0.36, kCupWider = 1.12;  // of an acorn's length, of its nut's width

Surface acorn_nut(double width) {
  constexpr double kFrom = 0.1;
  return closed_body(
      11, 16,
      [&](double t) {
        Vec2 at = half_circle(t, width);
        // It ends in a point, the rest of the style.
        at.y = static_cast<float>(kFrom + (1 - kFrom) * static_cast<double>(at.y) + (t > 0.97 ? 0.02 : 0.0));
        return at;
      },
      smooth_body);
}

Surface acorn_cup(double width) {
  constexpr double kRim = 0.8;      // of the outline, after which it runs inward
  constexpr double kScales = 0.06;  // of the radius
  return closed_body(
      9, 20,
      [&](double t) {
        const double out = std::min(t / kRim, 1.0), in = std::max(t - kRim, 0.0) / (1 - kRim);
        return Vec2(0.5 * kCupWider * width * std::sin(0.5 * kPi * out) * (1 - in),
                    kCupHigh * (1 - std::cos(0.5 * kPi * out)));
      },
      [&](double t, double turn) {
        return 1 + kScales * (t < kRim ? std::sin(10 * turn) * std::sin(9 * kPi * t) : 0.0);
      });
}

}  // namespace

void lay_sunward(Surface& body) {
  constexpr float kAxis = 1e-4f;
  body.uv.clear();
  Bounds box = bounds_of(body.position);
  const float high = std::max(box.high.y - box.low.y, kAxis);
  for (const Vec3& p : body.position) {
    const float out = glm::length(Vec2(p.x, p.z));
    body.uv.emplace_back(out > kAxis ? 0.5f + 0.5f * p.z / out : 0.5f, (p.y - box.low.y) / high);
  }
}

FruitParts fruit_parts(FruitForm form, double width) {
  FruitParts parts;
  switch (form) {
    case FruitForm::round:
      parts.body = round_body(width);
      break;
    case FruitForm::drop:
      parts.body = drop_body(width);
      break;
    case FruitForm::pod:
      parts.body = pod_body(width);
      break;
    case FruitForm::winged:
      parts.body = blade_surface({.width = width,
                                  .widest = 0.6,
                                  .fold = radians(3.0),
                                  .bend = radians(12.0),
                                  .stalk = 0.04,
                                  .detail = 2,
                                  .round = 0.6});
      return parts;
    case FruitForm::cone:
      parts.body = cone_body(width);
      break;
    case FruitForm::spiny:
      parts.body = spiny_body(width);
      break;
    case FruitForm::acorn:
      parts.body = acorn_nut(width);
      parts.cup = acorn_cup(width);
      lay_sunward(parts.cup);
  }
  lay_sunward(parts.body);
  return parts;
}

Surface stalk_surface() {
  constexpr int kSides = 5;
  Surface s;
  for (int k = 0; k < 2 * kSides; ++k) {
    const double turn = 2 * kPi * (k % kSides) / kSides;
    s.position.emplace_back(0.5 * std::cos(turn), k / kSides, -0.5 * std::sin(turn));
    s.uv.emplace_back(static_cast<float>(k % kSides) / kSides, static_cast<float>(k / kSides));
  }
  for (std::uint32_t k = 0; k < kSides; ++k) {
    const std::uint32_t next = (k + 1) % kSides;
    add_quad(s, k, next, kSides + next, kSides + k);
  }
  set_normals(s);
  return s;
}

}  // namespace frond
