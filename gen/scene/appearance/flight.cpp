#include "appearance/flight.h"

#include <algorithm>
#include <cmath>

namespace frond {

Flight flight(Vec3 from, Quat turn, float fallen, Seed own, const GroundAt& ground) {
  auto lot = [&](std::uint64_t k, double low, double high) {
    return static_cast<float>(own.child(k).range(low, high));
  };
  constexpr float kLeastHigh = 0.05f, kLies = 0.012f;  // metres that it falls, and over the ground
  constexpr float kSwing = 0.15f, kSwingHigh = 2;      // by the height that it falls, up to so many metres
  constexpr float kFlatFrom = 0.7f, kLooseTo = 0.6f;   // of the fall: where it turns flat, where it is loose
  float yaw = lot(10, 0, 2 * kPi), reach = lot(11, 0.05, 0.4);
  Vec3 aside(std::cos(yaw), 0, std::sin(yaw));
  float high = ground ? from.y - static_cast<float>(ground(from.x, from.z)) : std::max(from.y, 0.0f);
  high = std::max(high, kLeastHigh);
  Vec3 land = from + aside * (high * reach);
  land.y = ground ? static_cast<float>(ground(land.x, land.z)) + kLies : from.y - high;
  float down = fallen * (0.4f + 0.6f * fallen);
  float swing = kSwing * std::min(high, kSwingHigh) * std::sin(lot(12, 12, 22) * fallen) *
                std::sin(static_cast<float>(kPi) * fallen);
  Vec3 across(-aside.z, 0, aside.x);
  Vec3 axis = glm::normalize(Vec3(lot(13, -1, 1), lot(14, -1, 1), lot(15, -1, 1)) + Vec3(0.01f, 0, 0));
  Quat tumbling = glm::angleAxis(lot(16, 4, 14) * fallen, axis) * turn;
  Quat flat = glm::angleAxis(lot(17, 0, 2 * kPi), Vec3(0, 1, 0)) *
              glm::angleAxis(lot(18, -0.35, 0.35), Vec3(0, 0, 1)) *
              glm::angleAxis(-static_cast<float>(kPi / 2), Vec3(1, 0, 0));
  return {glm::mix(from, land, down) + across * swing,
          glm::normalize(glm::slerp(tumbling, flat, smooth_step(kFlatFrom, 1.0f, fallen))),
          smooth_step(0.0f, kLooseTo, fallen)};
}

Flight dropped(Vec3 from, Quat turn, float fallen, float half, Seed own, const GroundAt& ground) {
  constexpr float kLiesFrom = 0.85f;  // of the fall
  const auto yaw = static_cast<float>(own.child("lies").range(0, 2 * kPi));
  const float high = ground ? from.y - static_cast<float>(ground(from.x, from.z)) : std::max(from.y, 0.0f);
  const float down = std::max(0.0f, high - half) * fallen * fallen;
  const Quat lying =
      glm::angleAxis(yaw, Vec3(0, 1, 0)) * glm::angleAxis(static_cast<float>(kPi / 2), Vec3(1, 0, 0));
  return {from - Vec3(0, down, 0),
          glm::normalize(glm::slerp(turn, lying, smooth_step(kLiesFrom, 1.0f, fallen))),
          smooth_step(0.0f, 0.1f, fallen)};
}

}  // namespace frond
