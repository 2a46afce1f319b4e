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

Vec3 organ_place(const Skeleton& rest, const Pose& pose, const Organs& o, std::size_t i) {
  assert(i < o.size() && o.node[i] < static_cast<std::int32_t>(pose.position.size()));
  assert(o.loose.empty() || o.loose.size() == o.size());
  Vec3 riding = carried(rest, pose, o.node[i], o.position[i]);
  return o.loose.empty() || o.loose[i] == 0 ? riding : glm::mix(riding, o.position[i], o.loose[i]);
}

Quat organ_turn(const Pose& pose, const Organs& o, std::size_t i) {
  assert(i < o.size() && o.node[i] < static_cast<std::int32_t>(pose.turn.size()));
  Quat riding = carried_turn(pose, o.node[i]) * o.turn[i];
  return o.loose.empty() || o.loose[i] == 0 ? riding
                                            : glm::normalize(glm::slerp(riding, o.turn[i], o.loose[i]));
}

Model posed_organs(const Model& model, const Pose& pose, double ripen, float front) {
  constexpr float kFolded = 1e-3f;  // of its size
  Model posed;
  posed.prototypes = model.prototypes;
  const Organs& o = model.organs;
  for (std::size_t i = 0; i < o.size(); ++i) {
    if (unfolded(o.birth[i], front, ripen) < kUnfoldedLeast) continue;
    float size = std::max(unfolded(o.birth[i], pose.front, ripen), kFolded);
    posed.organs.prototype.push_back(o.prototype[i]);
    posed.organs.position.push_back(organ_place(model.skeleton, pose, o, i));
    posed.organs.turn.push_back(glm::normalize(organ_turn(pose, o, i)));
    posed.organs.scale.push_back(o.scale[i] * size);
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
