#include <algorithm>
#include <cmath>

#include "organisms/colony.h"

namespace frond {

namespace {

constexpr float kTurn = 0.35f;  // radians that a segment turns at most
constexpr float kBerth = 4;     // radii from which on a branch gives way

/// Where room grows fastest.
Vec3 roomiest_direction(const Surroundings& around, Vec3 at, float step, float within) {
  Vec3 slope(0);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 aside(0);
    aside[axis] = step;
    slope[axis] = around.room(at + aside, within) - around.room(at - aside, within);
  }
  float length = glm::length(slope);
  return length > 0 ? slope / length : Vec3(0);
}

/// The turn of a direction toward another by an angle at most.
Quat turn_toward(Vec3 direction, Vec3 goal, float angle) {
  Vec3 axis = glm::cross(direction, goal);
  float sine = glm::length(axis);
  if (sine < 1e-5f) return Quat(1, 0, 0, 0);
  return glm::angleAxis(std::min(angle, std::atan2(sine, glm::dot(direction, goal))), axis / sine);
}

/// The skeleton without some of its nodes; with a node go all above it.
Skeleton without(const Skeleton& s, const std::vector<char>& gone) {
  Skeleton left;
  std::vector<std::int32_t> number(s.size(), Skeleton::kRoot);
  left.reserve(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (gone[i]) continue;
    std::int32_t below =
        s.parent[i] == Skeleton::kRoot ? Skeleton::kRoot : number[static_cast<std::size_t>(s.parent[i])];
    number[i] = left.add(s.position[i], s.radius[i], below, s.order[i]);
  }
  set_tip_distances(left);
  set_births(left);
  return left;
}

}  // namespace

void keep_to_room(Skeleton& s, const Surroundings& around) {
  std::vector<Quat> turn(s.size(), Quat(1, 0, 0, 0));
  std::vector<char> gone(s.size());
  std::vector<Vec3> rest = s.position;
  bool changed = false;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.parent[i] == Skeleton::kRoot) continue;
    auto p = static_cast<std::size_t>(s.parent[i]);
    if (gone[p]) {
      gone[i] = 1;
      continue;
    }
    Vec3 segment = turn[p] * (rest[i] - rest[p]);
    turn[i] = turn[p];
    float length = glm::length(segment), berth = kBerth * s.radius[i] + length;
    float room = around.room(s.position[p] + segment, 2 * berth);
    // The foot stands in its rock.
    bool foot = s.distance[i] < 3 * s.radius[0];
    if (room < berth && length > 0 && !foot) {
      Vec3 out = roomiest_direction(around, s.position[p] + segment, 0.5f * s.radius[i] + 1e-3f, 2 * berth);
      float share = std::clamp(1 - (room - s.radius[i]) / (berth - s.radius[i]), 0.0f, 1.0f);
      Quat aside = turn_toward(segment / length, out, kTurn * share);
      segment = aside * segment;
      turn[i] = glm::normalize(aside * turn[i]);
      changed = true;
      if (around.room(s.position[p] + segment, 2 * berth) < 1.05f * s.radius[i]) {
        gone[i] = 1;
        continue;
      }
    }
    s.position[i] = s.position[p] + segment;
  }
  if (changed) s = without(s, gone);
}

}  // namespace frond
