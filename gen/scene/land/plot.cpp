#include "land/plot.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "core/polygon.h"
#include "foliage/organ_shapes.h"
#include "rocks/stone.h"

namespace frond {

namespace {

constexpr double kFar = 1e6;
constexpr int kPieces = 12;  // of the path from point to point

/// A point of the smooth curve through `points`, between i and i + 1.
Vec2 path_point(const std::vector<Vec2>& points, std::size_t i, float t) {
  auto at = [&](std::ptrdiff_t k) {
    return points[static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(k, 0, static_cast<std::ptrdiff_t>(points.size()) - 1))];
  };
  auto k = static_cast<std::ptrdiff_t>(i);
  Vec2 a = at(k - 1), b = at(k), c = at(k + 1), d = at(k + 2);
  Vec2 from_even = (c - a) * 0.5f, to_even = (d - b) * 0.5f;
  Vec2 leave = i > 0 ? spline_slopes(a, b, c).out : from_even;
  Vec2 arrive = i + 2 < points.size() ? spline_slopes(b, c, d).in : to_even;
  if (leave != from_even || arrive != to_even)
    return cubic_place(b, b + leave / 3.0f, c - arrive / 3.0f, c, t);
  return 0.5f * (2.0f * b + (c - a) * t + (2.0f * a - 5.0f * b + 4.0f * c - d) * (t * t) +
                 (3.0f * b - a - 3.0f * c + d) * (t * t * t));
}

double distance_to_piece(Vec2 at, Vec2 from, Vec2 to) {
  Vec2 segment = to - from;
  float length2 = glm::dot(segment, segment);
  float t = length2 > 0 ? std::clamp(glm::dot(at - from, segment) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::distance(at, from + segment * t);
}

/// A round leaf with a notch, its rim a little raised; diameter 1.
Surface pad_surface() {
  constexpr int kSides = 28;
  constexpr double kHalfNotch = 0.18;  // radians
  // Heights, as a share of the diameter: of the rim, of what waves add to it, and half-way to it.
  constexpr double kRimHeight = 0.014, kWaveHeight = 0.006, kInnerHeight = 0.008;
  constexpr int kWaves = 5;  // round the rim
  Surface s;
  s.position.emplace_back(0, 0.02f, 0);
  for (int ring = 1; ring <= 2; ++ring)
    for (int i = 0; i <= kSides; ++i) {
      double angle = kHalfNotch + (2 * kPi - 2 * kHalfNotch) * i / kSides, r = 0.25 * ring;
      double rim = ring == 2 ? kRimHeight + kWaveHeight * std::sin(kWaves * angle) : kInnerHeight;
      s.position.emplace_back(r * std::cos(angle), rim, r * std::sin(angle));
    }
  for (std::uint32_t i = 1; i <= kSides; ++i) {
    std::uint32_t a = i, b = i + 1, c = a + kSides + 1, d = b + kSides + 1;
    s.triangle.push_back({0, b, a});
    s.triangle.push_back({a, b, d});
    s.triangle.push_back({a, d, c});
  }
  set_normals(s);
  return s;
}

double rectangle_distance(Vec2 at, const GroundArea& area) {
  Vec2 away = glm::abs(at - area.center) - area.size / 2.0f;
  double edge = std::max(away.x, away.y);
  return edge < 0 ? edge : glm::length(glm::max(away, Vec2(0)));
}

/// Negative within a closed outline.
double outline_distance(Vec2 at, const std::vector<Vec2>& outline) {
  double best = kFar;
  for (std::size_t i = 0; i < outline.size(); ++i)
    best = std::min(best, distance_to_piece(at, outline[i], outline[(i + 1) % outline.size()]));
  return encloses(outline, at) ? -best : best;
}

}  // namespace

Plot::Plot(const PondShape& pond, const PathShape& path, Seed seed, std::vector<GroundArea> areas)
    : pond_(pond), half_width_(path.width / 2), areas_(std::move(areas)), seed_(seed) {
  for (const GroundArea& area : areas_) outlines_.push_back(area.corners());
  if (path.points.size() < 2) return;
  if (std::ranges::any_of(path.points, &SplinePoint<Vec2>::handled)) {
    path_ =
        spline_places(std::span<const SplinePoint<Vec2>>(path.points), {.smooth = true, .pieces = kPieces});
    return;
  }
  std::vector<Vec2> points = spline_points(path.points);
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (int k = 0; k < kPieces; ++k) path_.push_back(path_point(points, i, static_cast<float>(k) / kPieces));
  path_.push_back(points.back());
}

double Plot::pond_distance(Vec2 at) const {
  if (!has_pond()) return kFar;
  Vec2 scaled = (at - pond_.center) / pond_.size;
  double share = glm::length(scaled), least = std::min(pond_.size.x, pond_.size.y);
  if (share < 1e-6) return -least;
  // The shore comes and goes with the direction from the middle.
  constexpr double kBays = 0.16, kCoves = 0.05;  // shares of the way from the middle, by eye
  constexpr float kBaysOften = 1.3f;             // on a radian
  constexpr float kCovesFiner = 3.1f;            // than bays
  Vec2 out = scaled / static_cast<float>(share);
  Vec3 place(kBaysOften * out.x + static_cast<float>(seed_.child("pond").range(0, 99)), 0,
             kBaysOften * out.y);
  double shore = 1 + kBays * noise(place) + kCoves * noise(place * kCovesFiner);
  // Along the ray from the middle, so that it is right across the ellipse, too.
  double ray = glm::length(at - pond_.center) / share;
  return (share - shore) * ray;
}

double Plot::path_middle_distance(Vec2 at) const {
  double best = kFar;
  for (std::size_t i = 0; i + 1 < path_.size(); ++i)
    best = std::min(best, distance_to_piece(at, path_[i], path_[i + 1]));
  return best;
}

std::vector<Vec2> GroundArea::corners() const {
  return spline_places(std::span<const SplinePoint<Vec2>>(outline), {.smooth = curve, .closed = true});
}

std::array<Vec2, 2> GroundArea::box() const {
  if (outline.empty()) return {center - size / 2.0f, center + size / 2.0f};
  Vec2 low = outline[0].at, high = low;
  for (Vec2 at : corners()) low = glm::min(low, at), high = glm::max(high, at);
  return {low, high};
}

bool Plot::has_area(GroundArea::Kind kind) const {
  return std::ranges::find(areas_, kind, &GroundArea::kind) != areas_.end();
}

/// Their edges are cut with a spade: nearly straight.
double Plot::area_distance(Vec2 at, GroundArea::Kind kind) const {
  double best = kFar;
  for (std::size_t i = 0; i < areas_.size(); ++i)
    if (areas_[i].kind == kind)
      best = std::min(best, outlines_[i].empty() ? rectangle_distance(at, areas_[i])
                                                 : outline_distance(at, outlines_[i]));
  constexpr double kUneven = 0.02;  // metres
  constexpr float kOften = 5;       // on a metre
  return best > 1 ? best : best + kUneven * noise(Vec3(at.x * kOften, 3, at.y * kOften));
}

double Plot::earth_distance(Vec2 at) const { return area_distance(at, GroundArea::Kind::earth); }

double Plot::path_distance(Vec2 at) const {
  double area = area_distance(at, GroundArea::Kind::gravel);
  if (path_.size() < 2) return area;
  return std::min(area, curve_distance(at));
}

double Plot::curve_distance(Vec2 at) const {
  double best = path_middle_distance(at);
  if (best > 2 * half_width_ + 1) return best - half_width_;
  constexpr double kBroad = 0.07, kFine = 0.04;        // metres that the edge strays
  constexpr float kBroadOften = 1.6f, kFineOften = 6;  // on a metre
  return best - half_width_ + kBroad * noise(Vec3(at.x * kBroadOften, 5, at.y * kBroadOften)) +
         kFine * noise(Vec3(at.x * kFineOften, 9, at.y * kFineOften));
}

double Plot::height(Vec2 at, double lawn) const {
  // Metres, by eye.
  constexpr double kEvenAtPond = 2.5;  // the lawn is level at the shore, and as it was from here
  constexpr double kEvenFrom = -0.2, kEvenTo = 1.5;  // likewise at the edge of a path, where a third stays
  constexpr double kPathDepth = 0.025, kBedHeight = 0.05;
  constexpr double kWaterReach = 0.35;  // past the shore, as far as the water's disc may reach
  constexpr double kAboveWater = 0.06;  // the ground there
  constexpr double kBankWidth = 1.6;    // of the way from there down to the pond's depth
  double pond = pond_distance(at), path = has_path() ? path_distance(at) : kFar;
  double height =
      lawn * smooth_step(0.0, kEvenAtPond, pond) * (0.35 + 0.65 * smooth_step(kEvenFrom, kEvenTo, path));
  height -= kPathDepth * (1 - smooth_step(-0.12, 0.10, path));
  if (has_earth()) height += kBedHeight * (1 - smooth_step(-0.3, 0.0, earth_distance(at)));
  // No puddle: the water's disc is wider than the pond.
  if (pond > kWaterReach) height = std::max(height, pond_.level + kAboveWater);
  if (pond < kWaterReach) height -= pond_.depth * smooth_step(0.0, 1.0, (kWaterReach - pond) / kBankWidth);
  return height;
}

Solids water_lilies(const Plot& plot, int count, Seed seed) {
  Solids lilies;
  if (!plot.has_pond() || count <= 0) return lilies;
  Surface pad = pad_surface();
  for (Color color : {Color{0.19f, 0.34f, 0.10f}, Color{0.26f, 0.40f, 0.13f}, Color{0.33f, 0.36f, 0.14f}})
    lilies.add_shape({pad, {.color = color, .gloss = 0.5}});
  BladeShape petal{
      .width = 0.36, .widest = 0.5, .fold = radians(14.0), .bend = radians(-28.0), .stalk = 0, .round = 0.3};
  std::uint16_t outer =
      lilies.add_shape({corolla_surface(petal, 16, radians(52.0)), {.color = {0.96f, 0.86f, 0.90f}}});
  std::uint16_t heart = lilies.add_shape({heart_surface(0.3, 0.5, 40), {.color = {0.95f, 0.76f, 0.18f}}});

  constexpr int kLeavesAGroup = 14;
  constexpr std::uint64_t kThrows = 40;  // until a leaf is left out
  constexpr double kScatter = 0.16;      // of a group, as a share of the pond's size
  constexpr double kFromShore = 0.5;     // metres
  constexpr float kNearest = 0.92f;      // of the sum of their radii: how near leaves may lie
  constexpr double kFlowering = 0.13;    // share of leaves with a flower
  const PondShape& pond = plot.pond();
  int groups = std::max(1, count / kLeavesAGroup);
  std::vector<Vec3> taken;  // x, z and radius
  for (int i = 0; i < count; ++i) {
    Seed own = seed.child(static_cast<std::uint64_t>(i)),
         group = seed.child("group", static_cast<std::uint64_t>(i % groups));
    float radius = static_cast<float>(own.child("size").range(0.07, 0.17));
    for (std::uint64_t dart = 0; dart < kThrows; ++dart) {
      Seed toss = own.child("dart", dart);
      double angle = group.child("angle").range(0, 2 * kPi), out = group.child("out").range(0.25, 0.75);
      Vec2 at = pond.center + pond.size * Vec2(out * std::cos(angle) + kScatter * toss.child(0).normal(),
                                               out * std::sin(angle) + kScatter * toss.child(1).normal());
      bool free =
          plot.pond_distance(at) < -kFromShore && std::none_of(taken.begin(), taken.end(), [&](Vec3 other) {
            return glm::distance(Vec2(other.x, other.y), at) < kNearest * (other.z + radius);
          });
      if (!free) continue;
      taken.emplace_back(at, radius);
      Vec3 place(at.x, static_cast<float>(pond.level) + 0.004f, at.y);
      Quat turn = glm::angleAxis(static_cast<float>(own.child("turn").range(0, 2 * kPi)), Vec3(0, 1, 0));
      lilies.place(static_cast<std::uint16_t>(own.child("shade").bits() % 3), place, turn, Vec3(2 * radius));
      if (own.child("flower").unit() < kFlowering) {
        Vec3 beside = place + turn * Vec3(-0.6f * radius, 0.01f, 0);
        float size = static_cast<float>(own.child("open").range(0.07, 0.1));
        lilies.place(outer, beside, turn, Vec3(size));
        lilies.place(heart, beside + Vec3(0, 0.1f * size, 0), turn, Vec3(0.6f * size));
      }
      break;
    }
  }
  return lilies;
}

Surface gravel_surface(double side, double size, Seed seed) {
  constexpr int kShapes = 5;
  constexpr double kApart = 0.42;  // from stone to stone by their size, so that they cover the ground
  std::vector<Surface> shapes;
  for (std::uint64_t i = 0; i < kShapes; ++i)
    shapes.push_back(stone_surface({.seed = seed.child("shape", i), .roughness = 0.3, .flatness = 0.35}, 0));
  Surface gravel;
  double each = kApart * size;
  auto row = static_cast<std::uint64_t>(std::max(1.0, std::round(side / each)));
  for (std::uint64_t i = 0; i < row * row; ++i) {
    Seed own = seed.child(i);
    auto number = [&](std::uint64_t k, double low, double high) {
      return static_cast<float>(own.child(k).range(low, high));
    };
    const Surface& shape = shapes[own.child(0).bits() % kShapes];
    float wide = static_cast<float>(size) * number(1, 0.4, 1.0);
    Vec3 at((static_cast<double>(i % row) + number(2, 0, 1)) / static_cast<double>(row) * side - side / 2,
            wide * number(3, -0.05, 0.28),
            (static_cast<double>(i / row) + number(4, 0, 1)) / static_cast<double>(row) * side - side / 2);
    Quat turn = glm::angleAxis(number(5, 0, 2 * kPi), Vec3(0, 1, 0)) *
                glm::angleAxis(number(6, -0.3, 0.3), Vec3(1, 0, 0));
    auto offset = static_cast<std::uint32_t>(gravel.position.size());
    for (std::size_t k = 0; k < shape.position.size(); ++k) {
      gravel.position.push_back(at + turn * (shape.position[k] * wide));
      gravel.normal.push_back(turn * shape.normal[k]);
      gravel.uv.emplace_back(0, number(7, 0, 1));
    }
    for (auto [a, b, c] : shape.triangle) gravel.triangle.push_back({a + offset, b + offset, c + offset});
  }
  return gravel;
}

}  // namespace frond
