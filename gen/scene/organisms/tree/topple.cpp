#include "organisms/tree/topple.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "organisms/tree/tree.h"

namespace frond {

namespace {

constexpr double kTorn = 0.3;        // radians, at which the last roots break
constexpr double kLeastPush = 0.01;  // of what the roots hold: by so much the gust passes it at least
constexpr double kSudden = 2;        // times the weight, of a load that is put on at once
constexpr float kFarthest = 2.4f;    // radians that a tree may turn down a slope
constexpr float kSearch = 0.01f;     // radians, at least, from one look at the ground to the next
constexpr float kStout = 0.5f;       // of the stem's radius at its foot: such a piece of it never breaks

/// The tree as it turns.
class Turning {
 public:
  Turning(const Standing& now, const GrownTree& tree, const Fall& hinge)
      : now_(now), tree_(tree), hinge_(hinge.hinge), axis_(hinge.axis) {
    up_ = glm::normalize(Vec3(0, 1, 0) - axis_ * axis_.y);
    toward_ = glm::cross(axis_, up_);
  }

  Vec3 up() const { return up_; }
  /// Whether an internode is part of the tree, and not of a piece that broke off before.
  bool part(std::size_t i) const { return tree_.fell[now_.source[i]] == GrownTree::kNever; }
  /// Metres from the hinge across its axis: toward where it falls, and up.
  Vec2 across(Vec3 at) const { return {glm::dot(at - hinge_, toward_), glm::dot(at - hinge_, up_)}; }
  Vec3 turned(Vec3 at, float angle) const {
    Vec2 from = across(at);
    float c = std::cos(angle), s = std::sin(angle);
    return hinge_ + axis_ * glm::dot(at - hinge_, axis_) + toward_ * (from.x * c + from.y * s) +
           up_ * (from.y * c - from.x * s);
  }

  /// The angle at which the upper end of an internode meets the ground, or kFarthest.
  float contact(std::size_t i, const GroundHeight& ground) const {
    Vec3 tip = now_.tip[i];
    auto above = [&](Vec3 at) { return at.y - static_cast<float>(ground(at.x, at.z)); };
    float over = std::min(now_.radius[i], above(tip)), reach = std::max(glm::length(across(tip)), 0.1f);
    if (over < 0) return kFarthest;
    float angle = kSearch;
    while (angle < kFarthest) {
      float gap = above(turned(tip, angle)) - over;
      if (gap < 0) return angle;
      angle += std::max(kSearch, gap / (2 * reach));  // at most half of the way to a slope of 45 degrees
    }
    return kFarthest;
  }

 private:
  const Standing& now_;
  const GrownTree& tree_;
  Vec3 hinge_, axis_, up_, toward_;
};

/// Whether the limb that ends at internode `i` bears a force on its end, N, at an angle. If it does not,
/// marks where it breaks: where it is strained most.
bool bears(const Standing& now, const GrownTree& tree, const Turning& turning, const Wood& wood,
           std::size_t i, float angle, double force, std::vector<std::uint8_t>& broken) {
  Vec3 end = turning.turned(now.tip[i], angle);
  double most = wood.strength;
  std::size_t at = 0;
  for (std::size_t k = i; k != 0; k = static_cast<std::size_t>(now.parent[k])) {
    if (broken[k]) return false;
    double r = now.radius[k];
    if (tree.order[now.source[k]] == 0 && r >= kStout * now.radius[1]) break;
    Vec3 lever = end - turning.turned(now.tip[now.parent[k]], angle);
    double stress = 4 * force * std::hypot(lever.x, lever.z) / (kPi * r * r * r);
    if (stress > most) most = stress, at = k;
  }
  if (at != 0) broken[at] = true;
  return at == 0;
}

/// The angle at which the ground stops a body that is given but for that.
float stopping_angle(const Standing& now, const GrownTree& tree, const Wood& wood, const Turning& turning,
                     const Overturning& body, const GroundHeight& ground) {
  std::vector<std::pair<float, std::size_t>> contacts;
  for (std::size_t i = 1; i < now.size(); ++i) {
    if (!turning.part(i)) continue;
    if (float angle = turning.contact(i, ground); angle < kFarthest) contacts.emplace_back(angle, i);
  }
  std::ranges::sort(contacts);
  std::vector<std::uint8_t> broken(now.size());
  for (auto [angle, i] : contacts) {
    float lever = turning.across(turning.turned(now.tip[i], angle)).x;
    double moment = std::max(body.weight * std::sin(angle - body.balance), body.excess);
    double force = kSudden * moment / std::max(lever, 0.1f);
    if (bears(now, tree, turning, wood, i, angle, force, broken)) return angle;
  }
  return kFarthest;
}

/// The tree as a body that turns about that hinge. It stops at the first limb or piece of the stem that meets
/// the ground and bears the load; those that do not bear it break, and lie on the ground. The load is the
/// force that the ground must give there to hold the tree, twice, as for any load that is put on suddenly.
/// The mass is that of the wood and leaves, without the root plate.
Overturning overturning_of(const Standing& now, const GrownTree& tree, const Species& species,
                           const Fall& hinge, const GroundHeight& ground) {
  Turning turning(now, tree, hinge);
  const Wood& wood = species.wood;
  double mass = 0, along = 0, above = 0;
  Overturning body;
  body.inertia = 0;
  for (std::size_t i = 1; i < now.size(); ++i) {
    if (!turning.part(i)) continue;
    Vec3 base = now.foot[i];
    double r = now.radius[i], length = glm::distance(base, now.tip[i]);
    double m = wood.density * kPi * r * r * length + wood.leaf_mass * species.leaf_area * now.leaves[i];
    Vec2 at = turning.across((base + now.tip[i]) / 2.0f);
    mass += m, along += m * at.x, above += m * at.y;
    body.inertia += m * static_cast<double>(glm::dot(at, at));
  }
  body.inertia = std::max(body.inertia, 1e-6);
  body.weight = kGravity * std::hypot(along, above) * turning.up().y;
  body.balance = std::atan2(above, along) - kPi / 2;
  double hold = tree.uprooting.hold;
  body.excess = std::max(tree.uprooting.moment - hold, kLeastPush * hold);
  body.torn = std::max(kTorn, 2 * body.balance);
  body.stop = stopping_angle(now, tree, wood, turning, body, ground);
  return body;
}

}  // namespace

Fall hinge_of(const Standing& now, const GrownTree& tree, const GroundHeight& ground) {
  assert(now.size() > 1);
  const CutFace cut = cut_of(now, tree);
  const Vec3 foot = now.tip[0], toward = tree.uprooting.toward;
  double far = std::max((tree.uprooting.felled ? 1 : kRootPlate) * now.radius[1], 0.05f);
  auto slope = [&](double x, double z) {
    return static_cast<float>((ground(foot.x + x, foot.z + z) - ground(foot.x - x, foot.z - z)) / (2 * far));
  };
  Vec3 normal = glm::normalize(Vec3(-slope(far, 0), 1, -slope(0, far)));
  Vec3 along = glm::normalize(toward - normal * glm::dot(toward, normal));
  Fall fall;
  fall.hinge = cut.at + along * static_cast<float>(far);
  fall.axis = glm::cross(normal, along);
  return fall;
}

Fall fall_of(const Standing& now, const GrownTree& tree, const Species& species, const GroundHeight& ground) {
  Fall fall = hinge_of(now, tree, ground);
  fall.course = course_of(overturning_of(now, tree, species, fall, ground));
  return fall;
}

void lay_down(Model& model, const Fall& fall) {
  Skeleton& s = model.skeleton;
  Pose pose;
  pose_skeleton(s, {}, 0, pose);
  turn_fallen(
      fall, s, fall.start + fall.length(), [](double, double) { return 0.0; }, pose);
  Organs& o = model.organs;
  for (std::size_t i = 0; i < o.size(); ++i) {
    auto node = static_cast<std::size_t>(o.node[i]);
    o.position[i] = pose.position[node] + pose.turn[node] * (o.position[i] - s.position[node]);
    o.turn[i] = glm::normalize(pose.turn[node] * o.turn[i]);
  }
  s.position = pose.position;
}

}  // namespace frond
