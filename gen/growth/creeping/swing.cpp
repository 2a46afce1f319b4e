#include "creeping/swing.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/loop.h"
#include "core/parallel.h"
#include "creeping/hung_chain.h"
#include "creeping/swing_paths.h"

namespace frond {

namespace {

/// The turn by small angles about two level axes at once.
Quat tilt(const Vec3& along, double push, double side) {
  Vec3 axis = Vec3(-along.z, 0, along.x) * static_cast<float>(-push) + along * static_cast<float>(side);
  float angle = glm::length(axis);
  return angle < 1e-7f ? Quat(1, 0, 0, 0) : glm::angleAxis(angle, axis / angle);
}

constexpr double kMoments = 24;        // stored in a second
constexpr int kSubsteps = 6;           // of the simulation from moment to moment
constexpr double kLongest = 20;        // seconds after which it repeats at the latest
constexpr double kSettling = 8;        // seconds before the film
constexpr double kMostBlend = 2;       // seconds over which the end passes into the beginning,
constexpr double kBlendShare = 0.6;    // and share of a period, at most
constexpr double kUsedRoom = 0.8;      // share of the room; the rest is for rounding
constexpr double kTilt = kPi / 32767;  // radians of a step of what is stored

/// Two directions across a segment.
std::array<Vec3, 2> across(const Vec3& along) {
  Vec3 side = std::abs(along.y) < 0.9f ? Vec3(-along.z, 0, along.x) : Vec3(0, along.z, -along.y);
  side = direction_or(side, Vec3(1, 0, 0), 0);
  return {side, glm::cross(along, side)};
}

/// The air at a place: a mean speed and gusts of three sizes that travel with it (Taylor's hypothesis of
/// frozen turbulence), each a whole number of times in a period.
DVec3 air_at(const Breeze& breeze, const DVec3& place, double time, double period) {
  DVec3 along(direction_or(Vec3(breeze.direction.x, 0, breeze.direction.z), Vec3(1, 0, 0)));
  auto gust = [&](double size, double shift) {
    double rate = looping_rate(size * breeze.speed / breeze.gust, period);
    return std::sin(2 * kPi * (rate * time - size * glm::dot(place, along) / breeze.gust + shift) +
                    breeze.phase);
  };
  // The strengths of all are by eye.
  double ahead = 1 + 0.32 * gust(1, 0) + 0.22 * gust(1.7, 0.3) + 0.14 * gust(3.1, 0.6);
  double aside = 0.16 * gust(1.3, 0.1) + 0.1 * gust(2.3, 0.8);
  return breeze.speed * (along * ahead + DVec3(-along.z, 0, along.x) * aside);
}

HungStrand strand_of(const Strands& strands, const HangingRun& run, double stiffness) {
  const Skeleton& rest = strands.skeleton;
  HungStrand strand;
  std::int32_t root = rest.parent[run.first], before = rest.parent[root];
  strand.root = DVec3(rest.position[root]);
  strand.stiffness = stiffness;
  if (before != Skeleton::kRoot)
    strand.heading = direction_or(rest.position[root] - rest.position[before], Vec3(0, -1, 0));
  for (std::int32_t i = run.first; i <= run.last; ++i) {
    strand.place.emplace_back(rest.position[i]);
    strand.room.push_back(kUsedRoom * strands.room[i]);
  }
  if (run.bridged) strand.end = DVec3(rest.position[run.last + 1]);
  return strand;
}

/// The rotation of a segment from rest, as its two components across the segment at rest.
Vec2 tilt_of(const Vec3& rest, const Vec3& now) {
  Vec3 axis = glm::cross(rest, now);
  float sine = glm::length(axis), angle = std::atan2(sine, glm::dot(rest, now));
  if (sine > 0) axis *= angle / sine;
  auto [one, other] = across(rest);
  return {glm::dot(axis, one), glm::dot(axis, other)};
}

/// Simulates one run and stores it from `column` on.
void simulate(const Strands& strands, const Breeze& breeze, const HangingRun& run, double stiffness,
              std::size_t column, SwingPaths& paths) {
  const double step = paths.step / kSubsteps, period = paths.steps > 1 ? paths.steps * paths.step : 0;
  HungStrand strand = strand_of(strands, run, stiffness);
  const std::vector<DVec3> rest = strand.place;
  const DVec3 root = strand.root, middle = rest[rest.size() / 2];
  HungChain chain(std::move(strand), step);
  const int blend = static_cast<int>(std::min(kMostBlend, kBlendShare * period) / paths.step);
  const std::size_t n = rest.size();
  std::vector<Vec2> tilt;  // from `blend` moments before the film on
  tilt.reserve(static_cast<std::size_t>(blend + paths.steps) * n);
  auto segment = [&](const std::vector<DVec3>& place, std::size_t i) {
    return direction_or(Vec3(place[i] - (i == 0 ? root : place[i - 1])), Vec3(0, -1, 0));
  };
  for (int s = -blend - static_cast<int>(kSettling / paths.step); s < paths.steps; ++s) {
    for (std::size_t i = 0; i < n && s >= -blend; ++i)
      tilt.push_back(tilt_of(segment(rest, i), segment(chain.places(), i)));
    for (int k = 0; k < kSubsteps; ++k)
      chain.advance(air_at(breeze, middle, s * paths.step + k * step, period));
  }
  for (int s = 0; s < paths.steps; ++s) {
    int blended = s - (paths.steps - blend);
    float share =
        blended < 0 ? 0.0f : smooth_step(0.0f, 1.0f, static_cast<float>(blended) / static_cast<float>(blend));
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2* now = &tilt[static_cast<std::size_t>(s + blend) * n + i];
      Vec2 t = blended < 0 ? *now : glm::mix(*now, tilt[static_cast<std::size_t>(blended) * n + i], share);
      std::size_t at = static_cast<std::size_t>(s) * paths.node.size() + column + i;
      for (int axis : {0, 1})
        paths.tilt[at][static_cast<std::size_t>(axis)] =
            static_cast<std::int16_t>(std::lround(std::clamp(t[axis] / kTilt, -32767.0, 32767.0)));
    }
  }
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

SwingPaths swing_paths(const Strands& strands, const Breeze& breeze, double stiffness) {
  assert(breeze.speed > 0 && breeze.gust > 0);
  SwingPaths paths;
  double period = breeze.film_length / std::max(1.0, std::ceil(breeze.film_length / kLongest));
  paths.steps = std::max(1, static_cast<int>(std::ceil(period * kMoments - 1e-9)));
  paths.step = period > 0 ? period / paths.steps : 1 / kMoments;
  std::vector<HangingRun> runs = hanging_runs(strands);
  std::erase_if(runs,
                [&](const HangingRun& run) { return strands.skeleton.parent[run.first] == Skeleton::kRoot; });
  std::vector<std::size_t> column;
  for (const HangingRun& run : runs) {
    column.push_back(paths.node.size());
    for (std::int32_t i = run.first; i <= run.last; ++i) paths.node.push_back(i);
  }
  paths.tilt.resize(static_cast<std::size_t>(paths.steps) * paths.node.size());
  parallel_for(runs.size(),
               [&](std::size_t r) { simulate(strands, breeze, runs[r], stiffness, column[r], paths); });
  return paths;
}

void swing_strands(const Strands& strands, const SwingPaths& paths, double time, std::vector<Vec3>& position,
                   std::vector<Quat>& turn) {
  const Skeleton& rest = strands.skeleton;
  position = rest.position;
  turn.assign(rest.size(), Quat(1, 0, 0, 0));
  const double where = paths.steps > 1 ? time / paths.step : 0, whole = std::floor(where);
  const auto t = static_cast<float>(where - whole);
  // The spline of Catmull and Rom (1974) through four moments.
  const float weight[] = {0.5f * t * (t * (2 - t) - 1), 0.5f * (t * t * (3 * t - 5) + 2),
                          0.5f * t * (t * (4 - 3 * t) + 1), 0.5f * t * t * (t - 1)};
  const std::array<std::int16_t, 2>* moment[4];
  for (int k = 0; k < 4; ++k) {
    auto s = static_cast<std::int64_t>(whole) + k - 1;
    s = ((s % paths.steps) + paths.steps) % paths.steps;
    moment[k] = paths.tilt.data() + static_cast<std::size_t>(s) * paths.node.size();
  }
  for (std::size_t n = 0; n < paths.node.size(); ++n) {
    std::int32_t i = paths.node[n], below = rest.parent[i];
    Vec2 tilt(0);
    for (int k = 0; k < 4; ++k) tilt += weight[k] * Vec2(moment[k][n][0], moment[k][n][1]);
    tilt *= static_cast<float>(kTilt);
    Vec3 segment = rest.position[i] - rest.position[below];
    if (float angle = glm::length(tilt); angle > 0) {
      auto [one, other] = across(direction_or(segment, Vec3(0, -1, 0)));
      turn[i] = glm::angleAxis(angle, (tilt.x * one + tilt.y * other) / angle);
    }
    position[i] = position[below] + turn[i] * segment;
  }
}

}  // namespace frond
