#include "crown/colonize.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/cancellation.h"
#include "core/cell_grid.h"

namespace frond {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr int kPatience = 40;  // steps without coming nearer, until a point is given up

class Colony {
 public:
  Colony(const Envelope& envelope, const Colonization& how, Seed seed)
      : how_(how),
        points_(scatter(envelope, how, seed.child("points"))),
        grid_(static_cast<float>(std::max(how.influence / 3, how.kill))),
        nearest_(points_.size(), -1),
        distance_(points_.size(), kFar),
        patience_(points_.size(), kPatience),
        seed_(seed.child("grow")) {
    if (how.detour) std::erase_if(points_, [&](Vec3 p) { return !how.detour(p, p, 0); });
    for (std::uint32_t p = 0; p < points_.size(); ++p) grid_.add(points_[p], p);
  }

  Result<Skeleton> grow(const GuideAxes& guides) {
    if (points_.empty()) return Error{"", "the envelope has no room for branches"};
    add(Vec3(0), Skeleton::kRoot, Vec3(0, 1, 0));
    reach_envelope(follow(guides));
    for (std::uint64_t round = 0; round < 20000 && step(round); ++round) stay_wanted();
    return std::move(tree_);
  }

 private:
  /// Points of the envelope, thinned out inside or at the rim.
  static std::vector<Vec3> scatter(const Envelope& envelope, const Colonization& how, Seed seed) {
    if (how.crowding == 0) return envelope.sample(how.attractors, seed);
    std::vector<Vec3> all = envelope.sample(3 * how.attractors, seed), kept;
    Vec3 middle = (envelope.low() + envelope.high()) * 0.5f, half = (envelope.high() - envelope.low()) * 0.5f;
    for (std::size_t i = 0; i < all.size() && kept.size() < static_cast<std::size_t>(how.attractors); ++i) {
      Vec3 d = (all[i] - middle) / glm::max(half, Vec3(1e-6f));
      double out = std::min<double>(glm::length(d), 1);
      double chance = how.crowding > 0 ? 1 - how.crowding * (1 - out) : 1 + how.crowding * out;
      if (seed.child("thin", i).unit() < std::max(chance, 0.02)) kept.push_back(all[i]);
    }
    return kept;
  }

  std::int32_t add(Vec3 at, std::int32_t below, Vec3 toward) {
    std::int32_t node = tree_.add(at, 1, below, 0);
    toward_.push_back(toward);
    auto influence = static_cast<float>(how_.influence), kill = static_cast<float>(how_.kill);
    grid_.each(at - influence, at + influence, [&](std::uint32_t p) {
      if (distance_[p] < 0) return;
      float d = glm::distance(points_[p], at);
      if (d > influence || d >= distance_[p]) return;
      if (how_.detour && how_.detour(at, points_[p], kBarkGap) != points_[p]) return;
      distance_[p] = d <= kill ? -1 : d;
      nearest_[p] = node;
      patience_[p] = kPatience;
    });
    return node;
  }

  /// Lays the axes of guides. Returns the end of the first one.
  std::int32_t follow(const GuideAxes& guides) {
    std::vector<GuideAxis> axes = axes_of(guides);
    std::vector<std::vector<std::int32_t>> nodes(axes.size());
    for (std::size_t a = 0; a < axes.size(); ++a) {
      std::int32_t below = 0;
      if (a > 0) {
        const GuideAxis& from = axes[static_cast<std::size_t>(axes[a].off)];
        const auto& there = nodes[static_cast<std::size_t>(axes[a].off)];
        double share = (axes[a].from - from.from) / std::max(from.length(), 1e-9);
        auto last = static_cast<double>(there.size() - 1);
        below = there[static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * last))];
      }
      nodes[a].push_back(below);
      double length = axes[a].length();
      auto steps = static_cast<int>(std::min(std::ceil(length / how_.step), 1e5));
      for (int k = 1; k <= steps; ++k) {
        Vec3 at = axes[a].point(length * k / steps), offset = at - tree_.position[below];
        if (glm::length(offset) < 1e-6f) continue;
        below = add(at, below, glm::normalize(offset));
        nodes[a].push_back(below);
      }
    }
    return axes.empty() ? 0 : nodes[0].back();
  }

  /// A stem from its tip toward the nearest point until one is in reach.
  void reach_envelope(std::int32_t tip) {
    Vec3 goal = points_[0], from = tree_.position[tip];
    for (Vec3 p : points_)
      if (glm::distance(p, from) < glm::distance(goal, from)) goal = p;
    // Straight up first, then over to it.
    auto step = static_cast<float>(how_.step);
    for (int i = 0; i < 4000; ++i) {
      for (std::size_t p = 0; p < points_.size(); ++p)
        if (nearest_[p] >= 0 && distance_[p] > 0) return;
      Vec3 at = tree_.position[tip], offset = goal - at;
      if (glm::length(offset) < step) return;
      Vec3 up(0, std::max(offset.y, 0.0f), 0);
      Vec3 direction =
          glm::normalize(glm::length(up) > step ? glm::normalize(offset) + Vec3(0, 1, 0) : offset);
      std::optional<Vec3> end = way(at, at + direction * step);
      if (!end || (*end != at + direction * step && glm::distance(*end, goal) >= glm::distance(at, goal)))
        return;
      tip = add(*end, tip, direction);
    }
  }

  std::optional<Vec3> way(Vec3 from, Vec3 to) const {
    return how_.detour ? how_.detour(from, to, static_cast<float>(how_.step / 2)) : to;
  }

  /// One segment for each node that points attract; false when none does.
  bool step(std::uint64_t round) {
    pull_.clear();
    for (std::uint32_t p = 0; p < points_.size(); ++p) {
      if (distance_[p] < 0 || nearest_[p] < 0) continue;
      if (--patience_[p] < 0) {
        distance_[p] = -1;
        continue;
      }
      pull_.push_back({nearest_[p], p});
    }
    if (pull_.empty() || tree_.size() >= static_cast<std::size_t>(how_.most_nodes)) return false;
    std::sort(pull_.begin(), pull_.end());
    Seed seed = seed_.child(round);
    for (std::size_t i = 0; i < pull_.size();) {
      std::int32_t node = pull_[i].first;
      Vec3 at = tree_.position[node], sum(0);
      for (; i < pull_.size() && pull_[i].first == node; ++i)
        sum += glm::normalize(points_[pull_[i].second] - at);
      sum = glm::length(sum) > 1e-4f ? glm::normalize(sum) : toward_[static_cast<std::size_t>(node)];
      Seed own = seed.child(static_cast<std::uint64_t>(node));
      Vec3 random(own.child(0).range(-1, 1), own.child(1).range(-1, 1), own.child(2).range(-1, 1));
      sum += random * static_cast<float>(how_.jitter) + Vec3(0, how_.tropism, 0);
      if (glm::length(sum) < 1e-4f) sum = toward_[static_cast<std::size_t>(node)];
      Vec3 direction = glm::normalize(sum);
      assert(std::abs(glm::length(direction) - 1) < 1e-3f);
      std::optional<Vec3> end = way(at, at + direction * static_cast<float>(how_.step));
      if (end) add(*end, node, direction);
    }
    return true;
  }

  const Colonization& how_;
  std::vector<Vec3> points_;
  CellGrid grid_;
  std::vector<std::int32_t> nearest_;  // node of each point, or -1
  std::vector<float> distance_;        // to it; negative: taken or given up
  std::vector<int> patience_;
  std::vector<std::pair<std::int32_t, std::uint32_t>> pull_;
  std::vector<Vec3> toward_;  // the direction that each node came from
  Skeleton tree_;
  Seed seed_;
};

}  // namespace

Result<Skeleton> colonize(const Envelope& envelope, const Colonization& how, Seed seed,
                          const GuideAxes& guides) {
  assert(how.step > 0 && how.influence > 0 && how.kill >= 0);
  return Colony(envelope, how, seed).grow(guides);
}

std::vector<LeafSite> leaf_sites_near_tips(const Skeleton& s, double reach, double spacing, double down,
                                           Seed seed) {
  assert(spacing > 0 && s.to_tip.size() == s.size());
  std::vector<LeafSite> leaves;
  for (std::size_t i = 0; i < s.size(); ++i) {
    std::int32_t p = s.parent[i];
    if (p == Skeleton::kRoot || s.to_tip[i] > reach) continue;
    Vec3 from = s.position[p], offset = s.position[i] - from;
    float length = glm::length(offset);
    if (length < 1e-6f) continue;
    Vec3 axis = offset / length;
    Vec3 side = glm::cross(axis, reference_axis(axis));
    Quat frame =
        glm::quat_cast(glm::mat3(glm::normalize(side), axis, glm::normalize(glm::cross(side, axis))));
    // The leaves of a branch are counted from the root, so that they go on from segment to segment.
    auto first = static_cast<long long>(std::ceil(s.distance[p] / spacing));
    for (long long k = first; static_cast<double>(k) * spacing < s.distance[i]; ++k) {
      float t = static_cast<float>(static_cast<double>(k) * spacing - s.distance[p]) / length;
      Seed own = seed.child(i).child(static_cast<std::uint64_t>(k));
      double round = static_cast<double>(k) * kGoldenAngle + own.child(0).range(-0.5, 0.5);
      Quat turn = frame * glm::angleAxis(static_cast<float>(round), Vec3(0, 1, 0)) *
                  glm::angleAxis(static_cast<float>(down * own.child(1).range(0.75, 1.25)), Vec3(1, 0, 0)) *
                  glm::angleAxis(static_cast<float>(kPi), Vec3(0, 1, 0));
      leaves.push_back({from + offset * t, glm::normalize(turn),
                        static_cast<float>(own.child(2).range(0.75, 1)), static_cast<std::int32_t>(i)});
    }
  }
  return leaves;
}

}  // namespace frond
