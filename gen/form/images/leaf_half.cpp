#include "images/leaf_half.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "geometry/outline.h"
#include "images/leaf_blade.h"

namespace frond {

namespace {

constexpr int kFewestToPleat = 12;  // points of a rim
constexpr double kRidge = 0.42;     // height of a full ridge, as a share of the gap of secondaries
constexpr std::array<float, 2> kAlong{0.24f, 0.6f};       // places of points on a fold
constexpr std::array<double, 4> kRise{0, 0.75, 1, 0.55};  // of a ridge there, with its foot and its end

/// All triangles face the upper side.
void face_up(HalfBlade& half, std::size_t from) {
  for (std::size_t t = from; t < half.triangle.size(); ++t) {
    auto& [i, j, k] = half.triangle[t];
    Vec2 a = half.point[j] - half.point[i], b = half.point[k] - half.point[i];
    if (a.x * b.y - a.y * b.x < 0) std::swap(j, k);
  }
}

/// A straight fold from the midrib to the rim.
struct Fold {
  float foot = 0;    ///< height on the midrib
  double angle = 0;  ///< of its end on the rim, from the tip
  double ridge = 0;  ///< how far it is raised; 0 a valley
};

/// Valleys along the secondaries and ridges between them, from the foot to the tip.
std::vector<Fold> folds(const LeafOutline& outline, const Lamina& blade, int side, double pleat) {
  std::vector<Fold> valleys;
  for (const SecondaryLine& line : secondary_lines(outline)) {
    if (line.to.x * static_cast<float>(side) <= 0) continue;
    double x = std::abs(line.to.x) / outline.width, y = line.to.y - blade.middle().y;
    Fold fold{line.from.y, std::atan2(x, y), 0};
    bool after = valleys.empty() ||
                 (fold.foot > valleys.back().foot + 0.01f && fold.angle < valleys.back().angle - 0.02);
    if (after && fold.angle < kPi - 0.05 && blade.holds_way({0, fold.foot}, blade.at(fold.angle, 0.98)))
      valleys.push_back(fold);
  }
  std::vector<Fold> all;
  for (std::size_t i = 0; i < valleys.size(); ++i) {
    all.push_back(valleys[i]);
    if (i + 1 == valleys.size()) break;
    const Fold &a = valleys[i], &b = valleys[i + 1];
    Fold ridge{0.5f * (a.foot + b.foot), 0.5 * (a.angle + b.angle), 0};
    double gap = glm::distance(blade.at(a.angle, 0.5), blade.at(b.angle, 0.5));
    ridge.ridge = kRidge * pleat * std::min<double>(gap, b.foot - a.foot);
    if (blade.holds_way({0, ridge.foot}, blade.at(ridge.angle, 0.98))) all.push_back(ridge);
  }
  return all;
}

}  // namespace

HalfBlade half_blade(const LeafOutline& outline, int points) {
  std::vector<Vec2> rim = leaf_rim(outline, points);
  HalfBlade half;
  // Up the midrib on a few points, so that it bends, and down the rim.
  int ribs = points >= 10 ? 4 : points >= 6 ? 2 : 1;
  for (int i = 0; i < ribs; ++i) {
    Vec2 at = glm::mix(rim.back(), rim.front(), static_cast<float>(i) / static_cast<float>(ribs));
    half.point.emplace_back(at.x, at.y, 0);
  }
  for (std::size_t i = 0; i + 1 < rim.size(); ++i) half.point.emplace_back(rim[i].x, rim[i].y, 0);
  triangulate(half.point, 0, half.triangle);
  face_up(half, 0);
  return half;
}

HalfBlade pleated_half(const LeafOutline& outline, int points, int side, double pleat) {
  if (pleat <= 0 || points < kFewestToPleat) return half_blade(outline, points);
  Lamina blade(outline);
  std::vector<Fold> all = folds(outline, blade, side, pleat);
  if (all.size() < 3) return half_blade(outline, points);
  // The other half's folds begin on the same midrib, which both follow when it bends.
  std::vector<float> others;
  for (const Fold& fold : folds(outline, blade, -side, pleat)) others.push_back(fold.foot);
  HalfBlade half;
  auto add = [&](Vec2 p, double up) {
    half.point.emplace_back(p, static_cast<float>(up));
    return static_cast<std::uint32_t>(half.point.size() - 1);
  };
  std::vector<Vec2> rim = leaf_rim(outline, points);
  auto angle_of = [&](Vec2 p) { return std::atan2(p.x / outline.width, p.y - blade.middle().y); };
  // The fold before the first is the foot, the one behind the last the tip.
  std::vector<std::uint32_t> before{add(rim.back(), 0)};
  double from = kPi;
  for (std::size_t k = 0; k <= all.size(); ++k) {
    std::vector<std::uint32_t> line;
    double to = k < all.size() ? all[k].angle : 0;
    if (k < all.size()) {
      Vec2 foot(0, all[k].foot), end = blade.at(to);
      line.push_back(add(foot, 0));
      for (std::size_t i = 0; i < kAlong.size(); ++i)
        line.push_back(add(glm::mix(foot, end, kAlong[i]), all[k].ridge * kRise[i + 1]));
      line.push_back(add(end, all[k].ridge * kRise.back()));
    } else {
      line.push_back(add(rim.front(), 0));
    }
    // Round the strip between two folds: out along the first, along the rim, and back along the second.
    std::vector<std::uint32_t> round = before;
    double first = k > 0 ? all[k - 1].ridge : 0, second = k < all.size() ? all[k].ridge : 0;
    for (std::size_t i = rim.size() - 1; i-- > 1;)
      if (double a = angle_of(rim[i]); a < from - 1e-3 && a > to + 1e-3)
        round.push_back(add(rim[i], kRise.back() * std::lerp(first, second, (from - a) / (from - to))));
    round.insert(round.end(), line.rbegin(), line.rend());
    const float low = half.point[before.front()].y, high = half.point[line.front()].y;
    for (std::size_t i = others.size(); i-- > 0;)
      if (others[i] > low + 1e-4f && others[i] < high - 1e-4f) round.push_back(add({0, others[i]}, 0));
    std::vector<Vec3> flat;
    for (std::uint32_t i : round) flat.emplace_back(half.point[i].x, half.point[i].y, 0);
    std::vector<std::array<std::uint32_t, 3>> made;
    triangulate(flat, 0, made);
    std::size_t start = half.triangle.size();
    for (auto [a, b, c] : made) half.triangle.push_back({round[a], round[b], round[c]});
    face_up(half, start);
    before = std::move(line), from = to;
  }
  return half;
}

}  // namespace frond
