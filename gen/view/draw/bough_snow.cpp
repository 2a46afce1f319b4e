#include "draw/bough_snow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace frond {

namespace {

constexpr float kLeastHeap = 0.5f;  // pixels of its height
constexpr float kLeastTuft = 1.2f;  // pixels of its breadth
constexpr float kFineHeap = 2.5f;   // pixels of a branch's thickness from which on its heap is round

/// Share of snow that stays on what is inclined; `level` is the cosine of its angle.
float holding(float level) {
  static const float kNone = static_cast<float>(std::cos(radians(62.0))),
                     kAll = static_cast<float>(std::cos(radians(30.0)));
  return smooth_step(kNone, kAll, level);
}

/// A point of a heap's outline across a branch: where on its skin it begins, as an angle from the top, and
/// how far snow of height 1 moves it aside and up.
struct Across {
  float angle, aside, up;
};
constexpr std::array kRound{Across{-1.25f, 0.0f, 0.0f},   Across{-1.0f, -0.16f, 0.35f},
                            Across{-0.5f, -0.12f, 0.86f}, Across{0.0f, 0.0f, 1.0f},
                            Across{0.5f, 0.12f, 0.86f},   Across{1.0f, 0.16f, 0.35f},
                            Across{1.25f, 0.0f, 0.0f}};
constexpr std::array kSharp{Across{-1.2f, 0.0f, 0.0f}, Across{0.0f, 0.0f, 1.0f}, Across{1.2f, 0.0f, 0.0f}};

/// A place along a branch: its radius and the height of its snow, metres.
struct Station {
  Vec3 at, along;
  float radius, height;
};

/// Puts a strip of snow along a branch.
void add_heap(Surface& to, std::span<const Station> branch, std::span<const Across> outline) {
  constexpr float kSink = 0.93f;   // of the radius, where snow of no height lies
  constexpr float kAside = 0.45f;  // of the radius, by which snow overhangs at most
  auto n = static_cast<std::uint32_t>(outline.size());
  auto bare = [&](std::size_t k) { return k >= branch.size() || branch[k].height <= 0; };
  for (std::size_t k = 0; k < branch.size(); ++k) {
    const Station& s = branch[k];
    if (bare(k) && bare(k - 1) && bare(k + 1)) continue;
    Vec3 up = direction_or(Vec3(0, 1, 0) - s.along.y * s.along, Vec3(1, 0, 0), 1e-3f),
         side = glm::cross(s.along, up);
    auto first = static_cast<std::uint32_t>(to.position.size());
    for (const Across& a : outline) {
      float aside = kSink * s.radius * std::sin(a.angle) +
                    std::clamp(a.aside * s.height, -kAside * s.radius, kAside * s.radius);
      to.position.push_back(s.at + aside * side +
                            (kSink * s.radius * std::cos(a.angle) + a.up * s.height) * up);
    }
    if (bare(k) && bare(k - 1)) continue;
    if (k == 0) continue;
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      std::uint32_t a = first + i, b = a - n;
      to.triangle.push_back({b, b + 1, a});
      to.triangle.push_back({b + 1, a + 1, a});
    }
  }
}

/// The heaps of one organism.
class Heaps {
 public:
  Heaps(const DrawList& drawn, double time, double pixel)
      : drawn_(drawn),
        load_(*drawn.traits.load),
        time_(time),
        depth_(load_.depth.at(time)),
        deepest_(highest(load_.depth)),
        pixel_(static_cast<float>(std::max(pixel, 0.0005))) {}

  /// `needles`: thin branches are hidden in them.
  void add_chains(BoughSnow& snow, bool needles) const {
    const Skeleton& rest = drawn_.model.skeleton;
    for (std::size_t i = 0, end = 0; i < rest.size(); i = end) {
      for (end = i + 1; end < rest.size() && rest.parent[end] == static_cast<std::int32_t>(end) - 1;) ++end;
      add_chain(i, end, needles, snow);
    }
  }

  void add_tufts(BoughSnow& snow) const {
    const Model& model = drawn_.model;
    for (const OrganGroup& group : drawn_.organs.groups) {
      Bounds box = bounds_of(model.prototypes[group.prototype].parts.front().surface.position);
      if (!is_sprig(model.prototypes[group.prototype], box)) continue;
      std::span<const std::uint32_t> numbers = drawn_.organs.organs(group);
      std::span<const OrganPlace> places = drawn_.organs.places(group);
      for (std::size_t i = 0; i < places.size(); ++i)
        if (std::int32_t node = model.organs.node[numbers[i]]; node != Skeleton::kRoot)
          add_tuft(places[i], box, static_cast<std::size_t>(node), Seed{model.organs.id[numbers[i]]}, snow);
    }
  }

 private:
  void add_chain(std::size_t first, std::size_t end, bool needles, BoughSnow& snow) const {
    const Skeleton& rest = drawn_.model.skeleton;
    const Pose& pose = drawn_.pose;
    float most = 0, thickest = 0;
    std::vector<Station> branch;
    for (std::size_t i = first; i < end && rest.birth[i] <= pose.front; ++i) {
      std::int32_t below = rest.parent[i];
      Vec3 from =
          below == Skeleton::kRoot ? pose.position[i] : pose.position[static_cast<std::size_t>(below)];
      Vec3 along = direction_or(pose.position[i] - from, Vec3(0, 1, 0));
      if (branch.empty() && below != Skeleton::kRoot)
        branch.push_back({from, along, pose.radius[i], height_at(i, along)});
      bool last = i + 1 == end;
      if (!last && !branch.empty() &&
          glm::distance(branch.back().at, pose.position[i]) < std::max(4 * pixel_, 1.5f * pose.radius[i]))
        continue;
      branch.push_back({pose.position[i], along, pose.radius[i], last ? 0 : height_at(i, along)});
      thickest = std::max(thickest, pose.radius[i]);
      most =
          std::max(most, static_cast<float>(heap_height(deepest_, 2 * static_cast<double>(pose.radius[i]))));
    }
    bool fine = 2 * thickest > kFineHeap * pixel_;
    if (branch.size() < 2 || most < kLeastHeap * pixel_ || (needles && !fine)) return;
    add_heap(fine ? snow.heaps : snow.ridges, branch,
             fine ? std::span<const Across>(kRound) : std::span<const Across>(kSharp));
  }

  float height_at(std::size_t i, Vec3 along) const {
    float level = std::sqrt(std::max(0.0f, 1 - along.y * along.y));
    return static_cast<float>(heap_height(depth_, 2 * static_cast<double>(drawn_.pose.radius[i]))) *
           holding(level) * load_.share[i] * load_.left(i, time_);
  }

  /// Whether it is a sprig of needles, which stand out on all sides, and not flat.
  static bool is_sprig(const Prototype& organ, const Bounds& box) {
    return organ.parts.front().tissue == Tissue::leaf && box.size().z > 0.3f * box.size().x &&
           box.size().x < box.high.y;
  }

  void add_tuft(const OrganPlace& place, const Bounds& box, std::size_t node, Seed seed,
                BoughSnow& snow) const {
    constexpr float kBroad = 0.36f, kLong = 0.7f;  // of the needles' reach
    constexpr double kBare = 0.25;                 // share of sprigs that carry none
    Vec3 along = place.turn * Vec3(0, 1, 0);
    float level = std::sqrt(std::max(0.0f, 1 - along.y * along.y));
    float broad = kBroad * place.scale.x * box.size().x, load = load_.share[node] * load_.left(node, time_);
    if (broad < kLeastTuft * pixel_ || seed.child(0).unit() < kBare) return;
    float high = static_cast<float>(heap_height(depth_, 0.6 * static_cast<double>(broad)) *
                                    seed.child(1).range(0.5, 1.2)) *
                 holding(level) * load;
    if (high < 0.1f * broad) return;
    Vec3 up = direction_or(Vec3(0, 1, 0) - along.y * along, Vec3(1, 0, 0), 1e-3f);
    Quat turn = glm::quat_cast(glm::mat3(glm::cross(along, up), along, up));
    float share = std::min(1.0f, high / (0.3f * broad));  // what is low is small
    snow.tufts.push_back({place.at + 0.12f * place.scale.y * along, turn,
                          Vec3(broad * share, kLong * place.scale.y * box.high.y, high)});
  }

  const DrawList& drawn_;
  const SnowLoad& load_;
  double time_, depth_, deepest_;
  float pixel_;
};

}  // namespace

BoughSnow bough_snow(const DrawList& drawn, double time, double pixel) {
  BoughSnow snow;
  if (!drawn.traits.load || !drawn.branches) return snow;
  Heaps heaps(drawn, time, pixel);
  heaps.add_tufts(snow);
  heaps.add_chains(snow, !snow.tufts.empty());
  set_normals(snow.heaps);
  set_normals(snow.ridges);
  return snow;
}

Surface tuft_surface() {
  struct Ring {
    float y, broad, high;
  };
  constexpr std::array kRings{Ring{0.0f, 0.25f, 0.1f}, Ring{0.15f, 0.7f, 0.7f}, Ring{0.5f, 1.0f, 1.0f},
                              Ring{0.82f, 0.75f, 0.75f}, Ring{1.0f, 0.2f, 0.05f}};
  constexpr int kSides = 5;
  Surface tuft;
  for (const Ring& ring : kRings)
    for (int i = 0; i < kSides; ++i) {
      double turn = kPi * i / (kSides - 1);
      tuft.position.emplace_back(-0.5 * ring.broad * std::cos(turn), ring.y, ring.high * std::sin(turn));
    }
  for (std::uint32_t k = kSides; k < kSides * kRings.size(); k += kSides)
    for (std::uint32_t a = k; a + 1 < k + kSides; ++a) {
      tuft.triangle.push_back({a - kSides, a - kSides + 1, a});
      tuft.triangle.push_back({a - kSides + 1, a + 1, a});
    }
  set_normals(tuft);
  return tuft;
}

}  // namespace frond
