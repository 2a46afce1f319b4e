#include "foliage/organ_shapes.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

void append_turned(Surface& to, const Surface& from, const glm::mat3& turn, Vec3 shift) {
  append_mapped(
      to, from, [&](Vec3 p) { return turn * p + shift; }, [&](Vec3 n) { return turn * n; });
}

/// Half the width of a blade at `t`, as a share of the greatest: round at the foot, drawn out to a tip or
/// round.
double outline_at(double t, const BladeShape& shape) {
  if (t <= 0 || t >= 1) return 0;
  if (t < shape.widest) return std::pow(std::sin(t / shape.widest * kPi / 2), 0.8);
  double x = (1 - t) / (1 - shape.widest), point = std::pow(std::sin(x * kPi / 2), 1.15);
  return point + shape.round * (std::sqrt(1 - (1 - x) * (1 - x)) - point);
}

void drop_points(Surface& s) {
  std::erase_if(s.triangle,
                [&](const std::array<std::uint32_t, 3>& t) { return glm::length(area_of(s, t)) < 1e-7f; });
}

}  // namespace

Surface blade_surface(const BladeShape& shape) {
  Surface s;
  int stations = 4 * shape.detail - 1, across = shape.detail;  // along the blade, from midrib to rim
  // The two halves have midribs of their own, so that the fold is a crease.
  for (int side : {-1, 1}) {
    auto start = static_cast<std::uint32_t>(s.position.size());
    for (int i = 0; i <= stations; ++i) {
      double t = 1 - std::pow(1 - static_cast<double>(i) / stations, 1.4),
             along = shape.stalk + (1 - shape.stalk) * t;
      double half = std::max(0.5 * shape.width * outline_at(t, shape), 0.012 * (1 - t));
      double angle = shape.bend * along;
      // The midrib is an arc; the blade's upper side leans with it.
      double y = std::abs(shape.bend) > 1e-6 ? std::sin(angle) / shape.bend : along;
      double z = std::abs(shape.bend) > 1e-6 ? -(1 - std::cos(angle)) / shape.bend : 0;
      Vec3 up(0, std::sin(angle), std::cos(angle));
      for (int k = 0; k <= across; ++k) {
        double share = static_cast<double>(side < 0 ? across - k : k) / across;
        double rise = half * share * std::sin(shape.fold) * (1 - 0.45 * share);
        rise += 0.06 * shape.wave * share * share * std::sin(t * 17 + side);
        Vec3 at(side * half * share * std::cos(shape.fold), y, z);
        s.position.push_back(at + up * static_cast<float>(rise));
        s.uv.emplace_back(static_cast<float>(along), static_cast<float>(0.5 + 0.5 * side * share));
      }
    }
    stitch_rows(s, start, static_cast<std::uint32_t>(stations) + 1, static_cast<std::uint32_t>(across) + 1);
  }
  drop_points(s);
  set_normals(s);
  return s;
}

Surface corolla_surface(const BladeShape& petal, int count, double open) {
  Surface blade = blade_surface(petal), flower;
  for (int i = 0; i < count; ++i) {
    // A second whorl stands behind the first one, between its petals.
    bool behind = count > 8 && i % 2 == 1;
    double turn = 2 * kPi * i / count, lean = open + (behind ? 0.16 : 0.0) + 0.07 * std::sin(i * 5.3);
    Quat rotation = glm::angleAxis(static_cast<float>(turn), Vec3(0, 1, 0)) *
                    glm::angleAxis(static_cast<float>(lean), Vec3(1, 0, 0));
    // The upper side of a petal looks to the heart.
    Quat inward = glm::angleAxis(static_cast<float>(kPi), Vec3(0, 1, 0));
    append_turned(flower, blade, glm::mat3_cast(rotation * inward), Vec3(0, behind ? -0.015f : 0.0f, 0));
  }
  return flower;
}

Surface heart_surface(double radius, double flatness, int florets) {
  Surface s, seed = ball_surface();
  float dome = static_cast<float>(1 - flatness);
  append_turned(
      s, seed,
      glm::mat3(1.96 * radius, 0, 0, 0, static_cast<float>(1.7 * radius) * dome, 0, 0, 0, 1.96 * radius),
      Vec3(0));
  for (int i = 0; i < florets; ++i) {
    double share = std::sqrt((i + 0.5) / florets), angle = i * kGoldenAngle, r = radius * share;
    float size = static_cast<float>(2.1 * radius / std::sqrt(static_cast<double>(florets)));
    double height = radius * 0.85 * dome * std::sqrt(std::max(0.0, 1 - share * share));
    append_turned(s, seed, glm::mat3(size), Vec3(r * std::cos(angle), height, r * std::sin(angle)));
  }
  s.uv.clear();
  set_normals(s);
  return s;
}

Surface turned_surface(std::span<const float> profile, int sides) {
  Surface s;
  auto rows = static_cast<int>(profile.size());
  for (int i = 0; i < rows; ++i) {
    float y = static_cast<float>(i) / static_cast<float>(rows - 1), r = profile[i];
    for (int k = 0; k <= sides; ++k) {
      double angle = -2 * kPi * k / sides;
      s.position.emplace_back(r * static_cast<float>(std::cos(angle)), y,
                              r * static_cast<float>(std::sin(angle)));
    }
  }
  stitch_rows(s, 0, static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(sides) + 1);
  drop_points(s);
  set_normals(s);
  // The seam and the poles have several vertices in one place: one normal for all of them.
  auto n = static_cast<std::size_t>(sides) + 1;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    Vec3 both = glm::normalize(s.normal[i * n] + s.normal[i * n + n - 1]);
    s.normal[i * n] = s.normal[i * n + n - 1] = both;
    bool pole = profile[i] < 1e-4f;
    for (std::size_t k = 0; pole && k < n; ++k) s.normal[i * n + k] = Vec3(0, i == 0 ? -1 : 1, 0);
  }
  return s;
}

Surface ball_surface() {
  constexpr int kRows = 12, kSides = 20;
  std::array<float, kRows> profile;
  Surface s;
  for (int i = 0; i < kRows; ++i) profile[i] = static_cast<float>(0.5 * std::sin(kPi * i / (kRows - 1)));
  profile.front() = profile.back() = 0;
  s = turned_surface(profile, kSides);
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    auto row = static_cast<double>(i / (kSides + 1));
    s.position[i].y = static_cast<float>(-0.5 * std::cos(kPi * row / (kRows - 1)));
    s.normal[i] = glm::normalize(s.position[i]);
  }
  return s;
}

}  // namespace frond
