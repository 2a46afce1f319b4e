#include "creeping/swing.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/loop.h"
#include "creeping/hung_chain.h"

namespace frond {

namespace {

/// The turn by small angles about two level axes at once.
Quat tilt(const Vec3& along, double push, double side) {
  Vec3 axis = Vec3(-along.z, 0, along.x) * static_cast<float>(-push) + along * static_cast<float>(side);
  float angle = glm::length(axis);
  return angle < 1e-7f ? Quat(1, 0, 0, 0) : glm::angleAxis(angle, axis / angle);
}

}  // namespace

std::vector<HangingRun> hanging_runs(const Strands& s) {
  std::vector<HangingRun> runs;
  for (const Strand& strand : s.strands)
    for (std::int32_t i = strand.first, end = strand.first + strand.count; i < end; ++i) {
      if (!s.hanging[i]) continue;
      std::int32_t first = i;
      while (i + 1 < end && s.hanging[i + 1]) ++i;
      runs.push_back({first, i, i + 1 < end});
    }
  return runs;
}

void swing_strands(const Strands& strands, const Breeze& breeze, double time, std::vector<Vec3>& position,
                   std::vector<Quat>& turn) {
  constexpr double kSwingRoom = 0.6;     // share of the room
  constexpr double kFirstMode = 1.2024;  // half the first zero of j0
  constexpr double kSecondMode = 2.295;  // its second zero over the first
  constexpr double kGusts = 0.31;        // of the first mode's rate; by eye
  const Skeleton& rest = strands.skeleton;
  assert(strands.hanging.size() == rest.size() && strands.room.size() == rest.size());
  position = rest.position;
  turn.assign(rest.size(), Quat(1, 0, 0, 0));
  Vec3 flat(breeze.direction.x, 0, breeze.direction.z);
  Vec3 wind = glm::length(flat) > 0 ? glm::normalize(flat) : Vec3(1, 0, 0);
  for (const HangingRun& run : hanging_runs(strands)) {
    std::int32_t root = rest.parent[run.first];
    assert(run.first <= run.last && run.last < static_cast<std::int32_t>(rest.size()));
    if (root == Skeleton::kRoot) continue;
    double length = std::max<double>(rest.distance[run.last] - rest.distance[root], 1e-6);
    // No farther than there is room: a turn by an angle moves a node by less than that times its lever.
    double most = breeze.amplitude;
    Vec3 base = rest.position[root];
    Vec3 axis = run.bridged ? rest.position[run.last] - base : Vec3(0);
    bool bridged = glm::length(axis) > 1e-6f;
    if (bridged) axis = glm::normalize(axis);
    for (std::int32_t i = run.first; i <= run.last; ++i) {
      double lever = bridged ? glm::length(glm::cross(axis, rest.position[i] - base))
                             : rest.distance[i] - rest.distance[root];
      if (lever > 1e-3 * length) most = std::min(most, kSwingRoom * strands.room[i] / lever);
    }
    // Each strand has its own moment; frequencies are those of a heavy chain: j0 of the Bessel function.
    double phase = breeze.phase + 2 * kPi * Seed{static_cast<std::uint64_t>(run.first)}.child(7).unit();
    double slow_rate = kFirstMode * std::sqrt(kGravity / length) / (2 * kPi);
    double slow = 2 * kPi * looping_rate(slow_rate, breeze.film_length) * time + phase;
    double fast = 2 * kPi * looping_rate(kSecondMode * slow_rate, breeze.film_length) * time + 2.4 * phase;
    double gust = 2 * kPi * looping_rate(kGusts * slow_rate, breeze.film_length) * time + 1.7 * phase;
    double push = 0.35 + 0.3 * std::sin(gust) + 0.35 * std::sin(slow);
    for (std::int32_t i = run.first; i <= run.last; ++i) {
      double share = (rest.distance[i] - rest.distance[root]) / length;
      Quat q;
      if (bridged) {
        q = glm::angleAxis(static_cast<float>(most * push), axis);
      } else {
        // Lower parts of a chain turn more in the first mode, and against it in the second.
        constexpr double kAside = 0.4;  // of the swing with the wind
        double first = 0.55 + 0.45 * share, second = 0.28 * (1 - 2.2 * share);
        q = tilt(wind, most * (first * push + second * std::sin(fast)),
                 most * kAside * first * std::sin(0.5 * kPi + slow));
      }
      turn[i] = q;
      std::int32_t below = rest.parent[i];
      assert(below >= 0 && below < i);
      position[i] = position[below] + q * (rest.position[i] - rest.position[below]);
    }
  }
}

}  // namespace frond
