#include "motion/limbs.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace frond {

namespace {

constexpr double kFaster = 1.7;                                // from one order to the next
constexpr float kShare[] = {0.16f, 0.34f, 0.62f, 0.9f, 1.0f};  // of the amplitude, by order
constexpr double kFlutter = 5.3;                               // times the swing of the stem
const Vec3 kScatter(2.3f, 1.1f, 1.9f);  // 1/m: how fast phases change from place to place

/// The phase of a swing at a time, in a loop of whole swings.
float phase_at(double rate, double time, double film_length, bool loop) {
  if (loop && rate * film_length >= 0.5) rate = std::round(rate * film_length) / film_length;
  return static_cast<float>(std::remainder(2 * kPi * rate * time, 2 * kPi));
}

}  // namespace

LimbSway::LimbSway(const Skeleton& rest, const Wave& wave, double time, double film_length)
    : rest_(rest), base_(rest.size(), Skeleton::kRoot) {
  assert(wave.length != 0);
  assert(rest.order.size() == rest.size() && rest.to_tip.size() == rest.size());
  Vec3 flat(wave.direction.x, 0, wave.direction.z);
  along_ = glm::dot(flat, flat) > 0 ? glm::normalize(flat) : Vec3(1, 0, 0);
  across_ = Vec3(-along_.z, 0, along_.x);
  amplitude_ = static_cast<float>(wave.amplitude);
  wave_number_ = static_cast<float>(2 * kPi / wave.length);
  for (int order = 0; order < kOrders; ++order) {
    double rate = wave.speed * std::pow(kFaster, order);
    push_[order] = phase_at(rate, time, film_length, wave.loop) + static_cast<float>(wave.phase);
    side_[order] = phase_at(1.37 * rate, time, film_length, wave.loop) + static_cast<float>(2.4 * wave.phase);
  }
  for (std::size_t i = 0; i < rest.size(); ++i) {
    std::int32_t p = rest.parent[i];
    if (p != Skeleton::kRoot) base_[i] = rest.order[i] == rest.order[p] ? base_[p] : p;
  }
}

Quat LimbSway::turn(std::size_t i, const std::vector<Quat>& turns) {
  assert(i < base_.size() && turns.size() >= base_.size());
  std::int32_t base = base_[i];
  Quat borne = base == Skeleton::kRoot ? Quat(1, 0, 0, 0) : turns[base];
  float below = base == Skeleton::kRoot ? 0.0f : rest_.distance[base];
  float distance = rest_.distance[i] - below, share = distance / std::max(distance + rest_.to_tip[i], 1e-6f);
  if (share <= 0) return borne;
  int order = std::min<int>(rest_.order[i], kOrders - 1);
  Vec3 foot = base == Skeleton::kRoot ? Vec3(0) : rest_.position[base];
  float lag =
      wave_number_ * glm::dot(rest_.position[i], along_) + (order > 0 ? glm::dot(foot, kScatter) : 0.0f);
  float bend = amplitude_ * kShare[order] * share * std::sqrt(share);
  Vec3 axis = across_ * (-bend * (0.25f + 0.75f * std::sin(push_[order] - lag))) +
              along_ * (bend * 0.5f * std::sin(side_[order] - 1.3f * lag));
  float angle = glm::length(axis);
  if (angle < 1e-7f) return borne;
  return glm::normalize(borne * glm::angleAxis(angle, axis / angle));
}

void set_flutter(const Wave& wave, double time, double film_length, Pose& pose) {
  pose.flutter = static_cast<float>(std::min(1.2 * wave.amplitude, 0.5));
  pose.flutter_phase = phase_at(kFlutter * wave.speed, time, film_length, wave.loop);
}

}  // namespace frond
