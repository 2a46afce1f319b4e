#include "motion/unfold.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/loop.h"
#include "core/seed.h"

namespace frond {

float unfolded(float birth, float front, double ripen) {
  // What is born last still has all of `ripen` left.
  return smooth_step(0.0f, static_cast<float>(std::max(ripen, 1e-3)), front - birth);
}

float youth(const Skeleton& rest, const Pose& pose, float longest, float young_length, std::int32_t i) {
  if (young_length <= 0) return 0;
  float grown_past = std::max(pose.front - rest.birth[i], 0.0f) * longest;
  return 1 - smooth_step(0.0f, young_length, std::min(rest.to_tip[i], grown_past));
}

OrganPlace organ_place(const Model& model, const Motion& motion, const Pose& pose, double time, std::size_t i,
                       float size) {
  const Organs& o = model.organs;
  assert(i < o.size() && o.node[i] < static_cast<std::int32_t>(pose.position.size()));
  assert(o.loose.empty() || o.loose.size() == o.size());
  float loose = o.loose.empty() ? 0 : o.loose[i];
  Vec3 at = carried(model.skeleton, pose, o.node[i], o.position[i]);
  Quat turn = carried_turn(pose, o.node[i]) * o.turn[i];
  if (loose > 0) {
    at = glm::mix(at, o.position[i], loose);
    turn = glm::normalize(glm::slerp(turn, o.turn[i], loose));
  }
  if (float flutter = pose.flutter * (1 - loose); flutter > 0) {
    if (motion.sway && o.node[i] != Skeleton::kRoot)
      flutter *= pose.gusts[motion.sway->limb[static_cast<std::size_t>(o.node[i])]];
    float phase = pose.flutter_phase + 2.39996f * static_cast<float>(o.id[i] % 4096);
    turn = turn * glm::angleAxis(flutter * std::sin(phase), Vec3(1, 0, 0)) *
           glm::angleAxis(0.7f * flutter * std::sin(phase + 1.1f), Vec3(0, 1, 0));
  }
  if (!o.supple.empty())
    turn = turn * fluttering(motion.flutter, motion.film_length, time, o.position[i], o.id[i], o.supple[i]);
  return {at, turn, o.scale[i] * size};
}

Model posed_organs(const Model& model, const Motion& motion, const Pose& pose, double time, float front) {
  constexpr float kFolded = 1e-3f;  // of its size
  Model posed;
  posed.prototypes = model.prototypes;
  const Organs& o = model.organs;
  double ripen = unfold_time(motion);
  for (std::size_t i = 0; i < o.size(); ++i) {
    if (unfolded(o.birth[i], front, ripen) < kUnfoldedLeast) continue;
    float size = std::max(unfolded(o.birth[i], pose.front, ripen), kFolded);
    OrganPlace place = organ_place(model, motion, pose, time, i, size);
    posed.organs.prototype.push_back(o.prototype[i]);
    posed.organs.position.push_back(place.at);
    posed.organs.turn.push_back(glm::normalize(place.turn));
    posed.organs.scale.push_back(place.scale);
    posed.organs.color.push_back(o.color[i]);
    posed.organs.id.push_back(o.id[i]);
  }
  return posed;
}

Surface posed_blades(const Skeleton& rest, const Pose& pose, const Blades& all, double ripen,
                     const std::function<bool(std::size_t)>& wanted, float least) {
  assert(pose.position.size() == rest.size() && pose.turn.size() == rest.size());
  assert(all.first.size() == all.size() + 1 && all.first.back() == all.surface.position.size());
  Surface s;
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    // The triangles follow each other as the blades do.
    std::size_t first = triangle;
    while (triangle < all.surface.triangle.size() && all.surface.triangle[triangle][0] < all.first[i + 1])
      ++triangle;
    if (!wanted(i)) continue;
    float size = unfolded(all.birth[i], pose.front, ripen);
    if (size < least) continue;
    Quat turn = carried_turn(pose, all.node[i]);
    assert(all.node[i] < static_cast<std::int32_t>(rest.size()));
    Vec3 foot = carried(rest, pose, all.node[i], all.foot[i]);
    auto offset = static_cast<std::uint32_t>(s.position.size()) - all.first[i];
    for (std::uint32_t k = all.first[i]; k < all.first[i + 1]; ++k) {
      s.position.push_back(foot + turn * ((all.surface.position[k] - all.foot[i]) * size));
      s.normal.push_back(turn * all.surface.normal[k]);
      s.uv.push_back(all.surface.uv[k]);
    }
    for (; first < triangle; ++first) {
      auto [a, c, d] = all.surface.triangle[first];
      s.triangle.push_back({a + offset, c + offset, d + offset});
    }
  }
  return s;
}

Quat fluttering(const Flutter& flutter, double film_length, double time, Vec3 place, std::uint32_t id,
                float supple) {
  if (flutter.amplitude <= 0 || supple <= 0 || film_length <= 0) return Quat(1, 0, 0, 0);
  Seed own = Seed{id}.child("flutter");
  auto swing = [&](double speed, double phase) {
    return std::sin(2 * kPi * whole_turns(speed, film_length) * time / film_length + phase);
  };
  Vec3 flat(flutter.direction.x, 0, flutter.direction.z);
  if (glm::dot(flat, flat) > 0) flat = glm::normalize(flat);
  double lag = 2 * kPi * glm::dot(flat, place) / flutter.gust;
  double gust = 0.5 + 0.35 * swing(0.3, -lag) + 0.15 * swing(0.55, 2 - 1.7 * lag);
  double most = flutter.amplitude * std::min(supple, 2.0f) * gust;
  double speed = flutter.speed * own.child(0).range(0.8, 1.25);
  double nod = 0.6 * most * swing(speed, own.child(1).range(0, 2 * kPi));
  double twist = most * swing(1.37 * speed, own.child(2).range(0, 2 * kPi));
  return glm::angleAxis(static_cast<float>(nod), Vec3(1, 0, 0)) *
         glm::angleAxis(static_cast<float>(twist), Vec3(0, 1, 0));
}

}  // namespace frond
