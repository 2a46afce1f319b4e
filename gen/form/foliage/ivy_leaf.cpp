#include "foliage/ivy_leaf.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace frond {

namespace {

/// A point of the outline of half a leaf: degrees from the tip, distance from the blade's foot. Corners are
/// the tips of lobes; `coarse` ones make the outline of a leaf far away.
struct RimPoint {
  double angle, radius;
  bool corner = false, coarse = true;
};

/// A point that only a leaf nearby has.
constexpr RimPoint fine(double angle, double radius) { return {angle, radius, false, false}; }

constexpr RimPoint kArrow[] = {{0, 1.12, true}, fine(9, 0.86),     fine(17, 0.62),  {27, 0.45},
                               fine(40, 0.57),  {53, 0.74, true},  fine(64, 0.55),  {79, 0.38},
                               fine(97, 0.43),  {112, 0.53, true}, fine(130, 0.43), {150, 0.30},
                               fine(166, 0.17), {180, 0.06}};
constexpr RimPoint kFive[] = {{0, 1.0, true},  fine(10, 0.83),    fine(19, 0.66),  {29, 0.54},
                              fine(39, 0.63),  {50, 0.80, true},  fine(61, 0.65),  {76, 0.48},
                              fine(92, 0.52),  {108, 0.61, true}, fine(126, 0.52), {147, 0.38},
                              fine(165, 0.21), {180, 0.07}};
constexpr RimPoint kThree[] = {{0, 1.0, true},  fine(11, 0.86),   fine(22, 0.71),  {33, 0.62},
                               fine(44, 0.68),  {55, 0.78, true}, fine(68, 0.68),  {86, 0.58},
                               fine(104, 0.55), {122, 0.51},      fine(142, 0.43), {158, 0.31},
                               fine(170, 0.17), {180, 0.07}};
constexpr RimPoint kHeart[] = {{0, 1.05, true}, fine(8, 0.94), fine(18, 0.83),  {32, 0.74},
                               fine(48, 0.67),  {66, 0.61},    fine(86, 0.57),  {106, 0.53},
                               fine(126, 0.48), {144, 0.41},   fine(159, 0.29), fine(170, 0.17),
                               {180, 0.07}};

/// The directions of the lateral and the basal veins, degrees from the tip.
constexpr double kVeins[kIvyForms][2] = {{53, 112}, {50, 108}, {55, 122}, {48, 106}};
constexpr double kStandard[2] = {50, 110};  // where the texture has them

std::span<const RimPoint> rim_points(IvyForm form) {
  constexpr std::span<const RimPoint> kRims[kIvyForms] = {kArrow, kFive, kThree, kHeart};
  return kRims[static_cast<int>(form)];
}

/// The angle on the texture of an angle on the leaf, both 0..pi.
double standard_angle(IvyForm form, double angle) {
  const double* veins = kVeins[static_cast<int>(form)];
  double from[] = {0, radians(veins[0]), radians(veins[1]), kPi};
  double to[] = {0, radians(kStandard[0]), radians(kStandard[1]), kPi};
  int i = angle < from[1] ? 0 : angle < from[2] ? 1 : 2;
  return to[i] + (to[i + 1] - to[i]) * (angle - from[i]) / (from[i + 1] - from[i]);
}

/// How far between two veins a direction lies: 0 on a vein .. 1 in the middle.
double between_veins(IvyForm form, double angle) {
  constexpr double kFlatter = 0.6;  // between the basal veins and the stalk
  constexpr double kLateral = kStandard[0], kBasal = kStandard[1];
  double a = degrees(standard_angle(form, angle));
  double share = a < kLateral ? a / kLateral
                 : a < kBasal ? (a - kLateral) / (kBasal - kLateral)
                              : (a - kBasal) / (180 - kBasal);
  return std::sin(kPi * share) * (a < kBasal ? 1 : kFlatter);
}

/// The directions in which the mesh has spokes, from the tip to the foot.
std::vector<double> spokes(IvyForm form, int detail) {
  std::vector<double> angles;
  std::span<const RimPoint> points = rim_points(form);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (detail > 0 || points[i].coarse || points[i].corner) angles.push_back(radians(points[i].angle));
    if (detail > 1 && i + 1 < points.size())
      angles.push_back(radians((points[i].angle + points[i + 1].angle) / 2));
  }
  return angles;
}

class Leaf {
 public:
  explicit Leaf(const IvyLeafShape& shape) : shape_(shape), foot_(ivy_attachment(shape)) {}

  Surface build() {
    blade();
    set_normals(s_);
    petiole();
    return std::move(s_);
  }

 private:
  /// A place on the blade, `share` of the way to the rim.
  void blade_point(double angle, int side, double share) {
    constexpr double kHangMean = 0.55, kHangMore = 0.45;  // of the droop: all at the tip, little at the stalk
    constexpr double kRipple = 0.35;                      // of the wave: how high the rim's own ripples are
    constexpr double kTexture = 2.6;  // leaf lengths across the texture, as the header says
    double reach = ivy_rim(shape_.form, angle) * share;
    double x = side * reach * std::sin(angle), y = reach * std::cos(angle);
    double z = -shape_.droop * reach * reach * (kHangMean + kHangMore * std::cos(angle));
    z += shape_.wave * between_veins(shape_.form, angle) * share * (1.3 - share) * 2;
    if (shape_.detail > 0)
      z += kRipple * shape_.wave * share * share * std::sin(7 * angle + 2.2 * side + 9 * shape_.stalk);
    s_.position.push_back(foot_ + Vec3(x, y, z));
    double turned = standard_angle(shape_.form, angle);
    s_.uv.emplace_back(0.5 + side * reach * std::sin(turned) / kTexture,
                       0.5 + reach * std::cos(turned) / kTexture);
  }

  void blade() {
    std::vector<double> angles = spokes(shape_.form, shape_.detail);
    std::vector<double> rings = shape_.detail == 0   ? std::vector<double>{1}
                                : shape_.detail == 1 ? std::vector<double>{0.55, 1}
                                                     : std::vector<double>{0.3, 0.65, 1};
    auto half = static_cast<std::uint32_t>(angles.size()), n = 2 * half - 2 + 1;
    blade_point(0, 1, 0);
    for (double ring : rings) {
      // From the foot's notch on the left round the tip to the notch on the right.
      for (std::uint32_t i = half; i-- > 1;) blade_point(angles[i], -1, ring);
      for (double angle : angles) blade_point(angle, 1, ring);
    }
    for (std::uint32_t k = 0; k + 1 < n; ++k) {
      s_.triangle.push_back({0, 2 + k, 1 + k});
      for (std::uint32_t r = 0; r + 1 < rings.size(); ++r) {
        std::uint32_t a = 1 + r * n + k;
        add_quad(s_, a, a + 1, a + n + 1, a + n);
      }
    }
  }

  /// A thin bent prism from the origin to the blade: it leaves the strand outward and comes in from below.
  void petiole() {
    constexpr float kThin = 0.018f, kFoot = 0.008f,
                    kTop = 0.006f;    // radius; more of it at the foot, and at the blade
    constexpr float kBelow = 0.012f;  // how far below the blade it ends
    int sides = shape_.detail > 1 ? 5 : 3, pieces = shape_.detail > 1 ? 8 : shape_.detail > 0 ? 4 : 2;
    Vec3 bend = foot_ * Vec3(1, 0.42f, 0.85f), end = foot_ - Vec3(0, 0, kBelow);
    auto start = static_cast<std::uint32_t>(s_.position.size());
    for (int i = 0; i <= pieces; ++i) {
      float t = static_cast<float>(i) / static_cast<float>(pieces), o = 1 - t;
      Vec3 at = 2 * o * t * bend + t * t * end,
           direction = glm::normalize(2 * o * bend + 2 * t * (end - bend));
      Vec3 across(1, 0, 0), up = glm::cross(across, direction);
      float radius = kThin + kFoot * o * o * o + kTop * t * t * t;
      for (int k = 0; k <= sides; ++k) {
        float a = static_cast<float>(2 * kPi * k / sides);
        Vec3 out = std::cos(a) * across + std::sin(a) * up;
        s_.position.push_back(at + radius * out);
        s_.normal.push_back(glm::normalize(out));
        s_.uv.emplace_back(2 + t, static_cast<float>(k) / static_cast<float>(sides));
      }
    }
    stitch_rows(s_, start, static_cast<std::uint32_t>(pieces) + 1, static_cast<std::uint32_t>(sides) + 1);
  }

  const IvyLeafShape& shape_;
  Vec3 foot_;
  Surface s_;
};

}  // namespace

double ivy_rim(IvyForm form, double angle) {
  std::span<const RimPoint> p = rim_points(form);
  double a = std::clamp(std::abs(degrees(angle)), 0.0, 180.0);
  std::size_t i = 0;
  while (i + 2 < p.size() && p[i + 1].angle < a) ++i;
  // A cubic through the points (Catmull and Rom 1974) whose slope breaks off at the tips of lobes.
  auto slope = [&](std::size_t k, std::size_t other) {
    if (p[k].corner || k == 0 || k + 1 == p.size())
      return (p[other].radius - p[k].radius) / (p[other].angle - p[k].angle);
    return (p[k + 1].radius - p[k - 1].radius) / (p[k + 1].angle - p[k - 1].angle);
  };
  double span = p[i + 1].angle - p[i].angle, t = (a - p[i].angle) / span, o = 1 - t;
  return p[i].radius * o * o * (1 + 2 * t) + slope(i, i + 1) * span * t * o * o +
         p[i + 1].radius * t * t * (3 - 2 * t) - slope(i + 1, i) * span * t * t * o;
}

Vec3 ivy_attachment(const IvyLeafShape& shape) {
  return Vec3(0, shape.stalk * std::cos(shape.rise), shape.stalk * std::sin(shape.rise));
}

LeafDisc ivy_disc(const IvyLeafShape& shape) {
  // Area and centroid of the outline in polar coordinates, by the midpoint rule.
  constexpr int kSteps = 90;
  double area = 0, moment = 0;
  for (int i = 0; i < kSteps; ++i) {
    double angle = kPi * (i + 0.5) / kSteps, r = ivy_rim(shape.form, angle), da = 2 * kPi / kSteps;
    area += r * r / 2 * da;
    moment += r * r * r / 3 * std::cos(angle) * da;
  }
  float y = static_cast<float>(moment / area);
  Vec3 middle = ivy_attachment(shape) + Vec3(0, y, -static_cast<float>(shape.droop) * y * y);
  return {middle, static_cast<float>(std::sqrt(area / kPi))};
}

Surface ivy_leaf_surface(const IvyLeafShape& shape) { return Leaf(shape).build(); }

}  // namespace frond
