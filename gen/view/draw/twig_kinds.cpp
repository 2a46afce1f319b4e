#include "draw/twig_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr double kOrgansKept = 1100;  // on all twigs of the palette, about
constexpr std::size_t kFewestKinds = 40, kMostKinds = 240;
constexpr int kRounds = 8;  // of the search
constexpr float kLeastScale = 0.6f, kMostScale = 1.6f;
constexpr float kOther = 4;  // distance of twigs that bear different organs

using Point = std::array<float, 8>;

/// A twig as a point: as far apart as they look different.
Point point_of(const TwigTraits& t) {
  float size = std::sqrt(t.area);
  return {3.5f * std::log(t.area),
          3 * std::log((t.spread + 0.05f * size) / size),
          2 * std::log((t.reach + 0.05f * size) / size),
          2 * t.rise,
          3 * t.flat,
          1.5f * t.bend,
          2 * t.color,
          1.5f * std::log(t.count)};
}

float apart(const Point& a, const Point& b) {
  float sum = 0;
  for (std::size_t d = 0; d < a.size(); ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
  return sum;
}

std::vector<Point> points_of(std::span<const TwigTraits> twigs) {
  std::vector<Point> points;
  for (const TwigTraits& twig : twigs) points.push_back(point_of(twig));
  return points;
}

/// The number of the nearest of some points.
std::uint32_t nearest(const Point& point, std::span<const Point> among) {
  std::uint32_t best = 0;
  float least = 1e30f;
  for (std::uint32_t k = 0; k < among.size(); ++k)
    if (float far = apart(point, among[k]); far < least) least = far, best = k;
  return best;
}

std::size_t kinds_for(std::span<const TwigTraits> twigs) {
  double organs = 0;
  for (const TwigTraits& twig : twigs) organs += static_cast<double>(twig.count);
  auto wanted = static_cast<std::size_t>(kOrgansKept * static_cast<double>(twigs.size()) / organs);
  return std::min(std::clamp(wanted, kFewestKinds, kMostKinds), twigs.size());
}

}  // namespace

TwigTraits traits_of(const Model& model, std::int32_t node, std::span<const std::uint32_t> organs) {
  const Skeleton& s = model.skeleton;
  const Organs& o = model.organs;
  Vec3 joint = s.position[static_cast<std::size_t>(s.parent[static_cast<std::size_t>(node)])];
  TwigTraits t;
  Vec3 sum(0), squares(0);
  float weight = 0;
  for (std::uint32_t i : organs) {
    const Prototype& prototype = model.prototypes[o.prototype[i]];
    float own = glm::dot(o.scale[i], o.scale[i]);
    // An organ's middle is about half its length before its foot.
    Vec3 at = o.position[i] + o.turn[i] * Vec3(0, 0.5f * o.scale[i].y, 0) - joint;
    sum += own * at, squares += own * at * at, weight += own;
    auto colors = static_cast<float>(prototype.colors.size());
    t.color += own * static_cast<float>(color_index(o.color[i], prototype.colors.size())) / colors;
    t.bears |= std::uint64_t{1} << std::min<unsigned>(o.prototype[i], 63);
  }
  Vec3 middle = sum / weight, deviation = glm::max(squares / weight - middle * middle, Vec3(0));
  t.area = weight, t.count = static_cast<float>(organs.size()), t.color /= weight;
  t.reach = glm::length(middle);
  float spread2 = deviation.x + deviation.y + deviation.z;
  t.spread = std::sqrt(spread2);
  t.flat = spread2 > 0 ? deviation.y / spread2 : 0;
  Vec3 first = direction_or(s.position[static_cast<std::size_t>(node)] - joint, Vec3(0, 1, 0));
  Vec3 y = direction_or(middle, first);
  // Where it stands upright, whatever is not parallel to it will do.
  Vec3 aside = glm::cross(y, std::abs(y.y) < 0.98f ? Vec3(0, 1, 0) : Vec3(1, 0, 0));
  Vec3 x = glm::normalize(aside);
  t.axes = glm::normalize(glm::quat_cast(glm::mat3(x, y, glm::cross(x, y))));
  t.rise = std::asin(std::clamp(y.y, -1.0f, 1.0f));
  t.bend = glm::dot(first, y);
  return t;
}

float scale_between(const TwigTraits& from, const TwigTraits& to) {
  return std::clamp(std::sqrt(to.area / from.area), kLeastScale, kMostScale);
}

std::vector<std::uint32_t> choose_kinds(std::span<const TwigTraits> twigs) {
  std::vector<Point> points = points_of(twigs), middles;
  std::size_t count = kinds_for(twigs);
  for (std::size_t k = 0; k < count; ++k)
    middles.push_back(points[(2 * k + 1) * points.size() / (2 * count)]);
  std::vector<std::uint32_t> kind(points.size());
  for (int round = 0; round < kRounds; ++round) {
    parallel_for(points.size(), [&](std::size_t i) { kind[i] = nearest(points[i], middles); });
    std::vector<Point> sums(count);
    std::vector<float> members(count);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ++members[kind[i]];
      for (std::size_t d = 0; d < points[i].size(); ++d) sums[kind[i]][d] += points[i][d];
    }
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t d = 0; members[k] > 0 && d < sums[k].size(); ++d)
        middles[k][d] = sums[k][d] / members[k];
  }
  // The twig that is nearest to the middle of each kind.
  std::vector<std::uint32_t> kept;
  for (const Point& middle : middles) kept.push_back(nearest(middle, points));
  std::ranges::sort(kept);
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

std::vector<std::uint32_t> nearest_kinds(std::span<const TwigTraits> twigs,
                                         std::span<const std::uint32_t> kept) {
  std::vector<Point> points = points_of(twigs);
  std::vector<std::uint32_t> kind(twigs.size());
  parallel_for(twigs.size(), [&](std::size_t i) {
    float least = 1e30f;
    for (std::uint32_t k = 0; k < kept.size(); ++k) {
      float far = apart(points[i], points[kept[k]]) + (twigs[i].bears == twigs[kept[k]].bears ? 0 : kOther);
      if (far < least) least = far, kind[i] = k;
    }
  });
  return kind;
}

}  // namespace frond
