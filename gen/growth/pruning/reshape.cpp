#include <algorithm>
#include <cassert>
#include <cmath>

#include "pruning/edits.h"

namespace frond {

namespace {

constexpr float kCollar = 0.6f;  // radii of a branch that are left of it, beyond the bark of what bore it
constexpr float kStumpHeight = 1.0f;  // radii of a stem that are left of it
constexpr float kLeastSine = 0.4f;    // of the angle between a branch and what bears it
constexpr float kLeastPiece = 0.05f;  // of a segment that is cut

constexpr int kMostLoads = 400;
constexpr double kMostTurn = 0.08;   // radians at a joint by one load
constexpr double kNear = 2e-5;       // of the length: so near to the target it is there
constexpr float kWired = 1.0f / 3;   // of the thickest radius
constexpr double kDamping = 1e-3;    // of the compliance, along what cannot give way
constexpr double kStraight = 0.95;   // square of the share of its length that a straight limb reaches
constexpr double kLeastGain = 1e-4;  // of the distance to the target, by which a load has to lessen it

using DQuat = glm::dquat;

/// The force that moves the place by `error`: its compliance is the sum of c (|q|^2 - q q^T) of all joints.
DVec3 force_for(DVec3 error, std::span<const DVec3> lever, std::span<const double> compliance) {
  glm::dmat3 a(0);
  for (std::size_t k = 0; k < lever.size(); ++k) {
    const DVec3 q = lever[k];
    a += compliance[k] * (glm::dmat3(glm::dot(q, q)) - glm::outerProduct(q, q));
  }
  const double mean = (a[0][0] + a[1][1] + a[2][2]) / 3;
  if (!(mean > 0)) return DVec3(0);
  return glm::inverse(a + glm::dmat3(kDamping * mean)) * error;
}

/// The turns of the segments of a limb that is pulled by a force at one place, as a beam that is clamped at
/// its foot: by M l / (E I), with the moment M of the force at each joint and I ~ r^4 of round wood (Gere and
/// Timoshenko 1997, Mechanics of Materials), so that the place moves by about `by`, or as near as the length
/// allows. Large bends are made of many small loads, each on the shape that the ones before have left. Wood
/// thinner than a third of the thickest is taken for as stiff as that: a wire holds it. `nodes`: the clamp
/// first; `radius`: of each segment, one less; the place is `within` the last segment.
std::vector<Quat> bend_turns(std::span<const Vec3> nodes, std::span<const float> radius, float within,
                             Vec3 by) {
  const std::size_t n = radius.size();
  assert(nodes.size() == n + 1 && n > 0);
  const float thickest = *std::ranges::max_element(radius);
  std::vector<DVec3> offset(n), lever(n);
  std::vector<double> compliance(n);
  double length = 0;
  for (std::size_t k = 0; k < n; ++k) {
    offset[k] = DVec3(nodes[k + 1] - nodes[k]) * (k + 1 == n ? double{within} : 1.0);
    const double l = glm::length(offset[k]);
    compliance[k] = l / std::pow(std::max(radius[k], kWired * thickest) / thickest, 4);
    length += l;
  }
  std::vector<DQuat> turn(n, DQuat(1, 0, 0, 0));
  DVec3 target(by);
  for (const DVec3& o : offset) target += o;
  target *= std::min(1.0, length / std::max(glm::length(target), 1e-12));
  double before = HUGE_VAL;
  for (int load = 0; load < kMostLoads; ++load) {
    DVec3 place(0);
    for (std::size_t k = n; k-- > 0;) lever[k] = place += turn[k] * offset[k];
    DVec3 error = target - place;
    // A pull along a limb that is nearly straight would stretch it: no wire does that.
    const double chord2 = glm::dot(place, place), along = glm::dot(error, place);
    if (along > 0 && chord2 > kStraight * length * length) error -= place * (along / chord2);
    const double far = glm::length(error);
    if (far < kNear * length || far > before * (1 - kLeastGain)) break;
    before = far;
    const DVec3 force = force_for(error, lever, compliance);
    double most = 0;
    for (std::size_t k = 0; k < n; ++k)
      most = std::max(most, compliance[k] * glm::length(glm::cross(lever[k], force)));
    const double step = most > kMostTurn ? kMostTurn / most : 1;
    DQuat carried(1, 0, 0, 0);
    for (std::size_t k = 0; k < n; ++k) {
      const DVec3 angle = glm::cross(lever[k], force) * (compliance[k] * step);
      if (const double size = glm::length(angle); size > 1e-12)
        carried = carried * glm::angleAxis(size, angle / size);
      turn[k] = glm::normalize(carried * turn[k]);
    }
  }
  std::vector<Quat> result;
  for (const DQuat& q : turn) result.emplace_back(q);
  return result;
}

/// The edits of a plant, one after the other.
class Shaper {
 public:
  Shaper(const Branching& plant, std::span<const Vec3> position, std::span<const float> radius)
      : plant_(plant), rest_(position), radius_(radius), starts_(axis_starts(plant)) {
    const std::size_t n = position.size();
    out_.position.assign(position.begin(), position.end());
    out_.turn.assign(n, Quat(1, 0, 0, 0));
    out_.factor.assign(n, 1.0f);
    out_.gone.assign(n, 0);
  }

  Reshaped shape(std::span<const Edit> edits, std::span<const float> levers) {
    std::vector<std::optional<BranchPlace>> places;
    for (const Edit& edit : edits) places.push_back(place_of(edit));
    for (std::size_t i = 0; i < edits.size(); ++i)
      if (places[i] && edits[i].strength && *edits[i].strength != 1)
        strengthen(*places[i], *edits[i].strength);
    if (out_.any) stretch();
    out_.levers.assign(edits.size(), 0);
    for (std::size_t i = 0; i < edits.size(); ++i)
      if (places[i] && edits[i].bend && *edits[i].bend != Vec3(0))
        out_.levers[i] = bend(*places[i], *edits[i].bend, i < levers.size() ? levers[i] : 0);
    for (std::size_t i = 0; i < edits.size(); ++i)
      if (places[i] && edits[i].cut && !edits[i].dated()) cut(*places[i]);
    std::erase_if(out_.ends, [&](const CutEnd& end) { return out_.gone[end.node]; });
    return std::move(out_);
  }

 private:
  std::optional<BranchPlace> place_of(const Edit& edit) {
    if (edit.dated()) return std::nullopt;
    Result<BranchPlace> place = find_place(plant_, starts_, edit.at);
    if (place) return *place;
    out_.notes.push_back("/edits/" + std::to_string(edit.number) + "/at: " + place.errors().front().what);
    return std::nullopt;
  }

  void strengthen(BranchPlace place, double by) {
    for_beyond(plant_.parent, place.node, [&](std::size_t i) { out_.factor[i] *= static_cast<float>(by); });
    out_.any = true;
  }

  /// Lengthens all segments by their factors.
  void stretch() {
    for (std::size_t i = 0; i < rest_.size(); ++i)
      if (const std::int32_t p = plant_.parent[i]; p != Skeleton::kRoot)
        out_.position[i] = out_.position[p] + (rest_[i] - rest_[p]) * out_.factor[i];
  }

  /// The nodes of an axis up to one, in order; without that from which it leaves, or of a stem its foot.
  std::vector<std::int32_t> limb_to(std::int32_t node) const {
    std::vector<std::int32_t> limb;
    for (std::int32_t i = node; plant_.parent[i] != Skeleton::kRoot; i = plant_.parent[i]) {
      limb.push_back(i);
      if (i == starts_[node]) break;
    }
    std::ranges::reverse(limb);
    return limb;
  }

  /// Gives the length that is bent. `whole`: the same of the whole plant, or 0.
  float bend(BranchPlace place, Vec3 by, float whole) {
    const std::vector<std::int32_t> limb = limb_to(place.node);
    if (limb.empty()) return 0;
    std::vector<Vec3> nodes{out_.position[plant_.parent[limb[0]]]};
    std::vector<float> thick;
    float lever = 0;
    for (std::int32_t i : limb) {
      const float length = glm::distance(nodes.back(), out_.position[i]);
      lever += length * (i == place.node ? place.within : 1);
      nodes.push_back(out_.position[i]);
      thick.push_back(radius_[i] * out_.factor[i]);
    }
    if (lever <= 0) return 0;
    if (whole > 0) by *= std::min(lever / whole, 1.0f);
    const std::vector<Quat> turns = bend_turns(nodes, thick, place.within, by);
    // What hangs on a segment is turned with it.
    std::vector<std::int32_t> segment(rest_.size(), -1);
    for (std::size_t k = 0; k < limb.size(); ++k) segment[limb[k]] = static_cast<std::int32_t>(k);
    const std::vector<Vec3> before = out_.position;
    for (auto i = static_cast<std::size_t>(limb[0]); i < rest_.size(); ++i) {
      const std::int32_t p = plant_.parent[i];
      if (p == Skeleton::kRoot) continue;
      if (segment[i] < 0) segment[i] = segment[p];
      if (segment[i] < 0) continue;
      const Quat& turn = turns[static_cast<std::size_t>(segment[i])];
      out_.position[i] = out_.position[p] + turn * (before[i] - before[p]);
      out_.turn[i] = glm::normalize(turn * out_.turn[i]);
    }
    out_.any = true;
    return lever;
  }

  /// How much of a limb a cut leaves at least, metres, so that what bore it is not hurt.
  float collar(std::int32_t first) const {
    const std::int32_t on = plant_.parent[first];
    const float own = radius_[first] * out_.factor[first];
    if (on == Skeleton::kRoot) return kStumpHeight * own;
    const std::int32_t below = plant_.parent[on];
    if (below == Skeleton::kRoot) return radius_[on] + kCollar * own;
    const Vec3 out = rest_[first] - rest_[on], along = rest_[on] - rest_[below];
    const float size = std::max(glm::length(out) * glm::length(along), 1e-12f);
    const float sine = std::max(glm::length(glm::cross(out, along)) / size, kLeastSine);
    return radius_[on] * out_.factor[on] / sine + kCollar * own;
  }

  /// The place so many metres along an axis; its node is kRoot if the axis is shorter.
  BranchPlace place_along(std::int32_t start, float metres) const {
    for (auto i = static_cast<std::size_t>(start); i < rest_.size(); ++i) {
      const std::int32_t p = plant_.parent[i];
      if (starts_[i] != start || p == Skeleton::kRoot) continue;
      const float length = glm::distance(out_.position[p], out_.position[i]);
      if (metres <= length) return {static_cast<std::int32_t>(i), length > 0 ? metres / length : 1};
      metres -= length;
    }
    return {Skeleton::kRoot, 0};
  }

  void cut(BranchPlace place) {
    out_.any = true;
    const std::int32_t start = starts_[place.node];
    float along = 0;
    for (std::int32_t i : limb_to(place.node))
      along += glm::distance(out_.position[plant_.parent[i]], out_.position[i]) *
               (i == place.node ? place.within : 1);
    const float least = collar(start);
    BranchPlace at = along < least ? place_along(start, least) : place;
    if (at.node == Skeleton::kRoot) {
      for_beyond(plant_.parent, start,
                 [&](std::size_t i) { out_.gone[i] = plant_.parent[i] != Skeleton::kRoot; });
      return;
    }
    for_beyond(plant_.parent, at.node, [&](std::size_t i) {
      if (static_cast<std::int32_t>(i) != at.node) out_.gone[i] = 1;
    });
    at.within = std::max(at.within, kLeastPiece);
    auto same = std::ranges::find(out_.ends, at.node, &CutEnd::node);
    if (same == out_.ends.end())
      out_.ends.push_back({at.node, at.within});
    else
      same->within = std::min(same->within, at.within);
  }

  const Branching& plant_;
  std::span<const Vec3> rest_;
  std::span<const float> radius_;
  std::vector<std::int32_t> starts_;
  Reshaped out_;
};

}  // namespace

std::vector<Edit> edits_of(std::span<const Edit> edits, std::optional<std::size_t> planting) {
  std::vector<Edit> own;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (edits[i].plant && edits[i].plant != planting) continue;
    own.push_back(edits[i]);
    own.back().number = i;
  }
  return own;
}

Reshaped reshape(const Branching& plant, std::span<const Vec3> position, std::span<const float> radius,
                 std::span<const Edit> edits, std::span<const float> levers) {
  assert(plant.parent.size() == position.size() && plant.axes.size() == position.size());
  return Shaper(plant, position, radius).shape(edits, levers);
}

}  // namespace frond
