#include <algorithm>
#include <cmath>

#include "foliage/organ_shapes.h"
#include "organisms/ivy/ivy.h"

namespace frond {

namespace {

// The beetle, in its own lengths, by eye: it heads for +y, its upper side is +z, and it stands on z = 0.

constexpr int kGaits = 8;         // shapes of a step
constexpr double kStride = 0.45;  // how far it comes forward in one

/// An ellipsoid about a middle, with these half axes; nothing of it is below `lowest`.
struct BeetlePart {
  Vec3 middle, half;
  float lowest;
};

constexpr BeetlePart kWingCovers{{0, -0.11f, 0.16f}, {0.24f, 0.36f, 0.19f}, 0.10f};
constexpr BeetlePart kNeckShield{{0, 0.24f, 0.15f}, {0.18f, 0.13f, 0.12f}, 0.09f};
constexpr BeetlePart kBeetleHead{{0, 0.39f, 0.13f}, {0.11f, 0.10f, 0.08f}, 0.07f};
constexpr BeetlePart kBeetleBelly{{0, 0.02f, 0.12f}, {0.17f, 0.36f, 0.05f}, 0.07f};

/// A piece of a feeler of its right side.
struct FeelerPiece {
  Vec3 from, till;
  float thick, thin;  // radii at its ends
};

constexpr FeelerPiece kFeeler[] = {{{0.06f, 0.46f, 0.15f}, {0.15f, 0.56f, 0.20f}, 0.012f, 0.010f},
                                   {{0.15f, 0.56f, 0.20f}, {0.24f, 0.72f, 0.14f}, 0.012f, 0.006f}};

/// Its legs, three on each side.
struct BeetleLegs {
  float hip_aside = 0.12f, hip_up = 0.11f;
  float first_hip = 0.24f, to_next_hip = 0.2f;      // along the body
  float first_reach = 0.16f, reach_to_next = 0.2f;  // of a foot before its hip; the next reaches less
  float foot_aside = 0.46f, foot_up = 0.01f;
  float knee_aside = 0.06f, knee_up = 0.14f;  // from midway between hip and foot
  float hip_radius = 0.026f, knee_radius = 0.02f, foot_radius = 0.01f;
  double lift = 0.06;  // of a foot that steps
};

void add_part(Surface& to, const BeetlePart& part) {
  Surface ball = ball_surface();
  auto first = static_cast<std::uint32_t>(to.position.size());
  for (const Vec3& p : ball.position) {
    Vec3 at = part.middle + 2.0f * part.half * p;
    to.position.push_back({at.x, at.y, std::max(at.z, part.lowest)});
  }
  for (auto [a, b, c] : ball.triangle) to.triangle.push_back({first + a, first + b, first + c});
}

/// Adds a three-sided rod that tapers.
void add_rod(Surface& to, Vec3 from, Vec3 till, float thick, float thin) {
  Vec3 along = glm::normalize(till - from);
  Vec3 side = glm::normalize(glm::cross(along, std::abs(along.z) < 0.9f ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
  Vec3 other = glm::cross(along, side);
  auto first = static_cast<std::uint32_t>(to.position.size());
  for (auto [at, radius] : {std::pair(from, thick), std::pair(till, thin)})
    for (int k = 0; k < 3; ++k) {
      auto turn = static_cast<float>(2 * kPi * k / 3);
      to.position.push_back(at + radius * (std::cos(turn) * side + std::sin(turn) * other));
    }
  for (std::uint32_t k = 0; k < 3; ++k) {
    std::uint32_t next = (k + 1) % 3;
    to.triangle.push_back({first + k, first + next, first + 3 + next});
    to.triangle.push_back({first + k, first + 3 + next, first + 3 + k});
  }
}

/// Wing covers, and the shield before them.
Surface beetle_back() {
  constexpr float kSeamDepth = 0.02f, kSeamWidthSquared = 0.0008f;  // between the wing covers
  Surface s;
  add_part(s, kWingCovers);
  for (Vec3& p : s.position) p.z -= kSeamDepth * std::exp(-(p.x * p.x) / kSeamWidthSquared);
  add_part(s, kNeckShield);
  set_normals(s);
  return s;
}

/// Head, feelers and legs at a moment 0..1 of the gait: three legs stand while the other three step.
Surface beetle_limbs(double moment) {
  constexpr BeetleLegs kLegs{};
  Surface s;
  add_part(s, kBeetleHead);
  add_part(s, kBeetleBelly);
  for (float side : {-1.0f, 1.0f}) {
    auto at_side = [&](Vec3 right) { return Vec3(side * right.x, right.y, right.z); };
    for (auto [from, till, thick, thin] : kFeeler) add_rod(s, at_side(from), at_side(till), thick, thin);
    for (int leg = 0; leg < 3; ++leg) {
      bool odd = (leg == 1) != (side > 0);
      double turn = 2 * kPi * (moment + (odd ? 0.5 : 0));
      auto swing = static_cast<float>(0.5 * kStride * 0.5 * std::cos(turn));
      auto lift = static_cast<float>(std::max(0.0, -std::sin(turn)) * kLegs.lift);
      float from = kLegs.first_hip - kLegs.to_next_hip * static_cast<float>(leg),
            reach = kLegs.first_reach - kLegs.reach_to_next * static_cast<float>(leg);
      Vec3 hip(side * kLegs.hip_aside, from, kLegs.hip_up),
          foot(side * kLegs.foot_aside, from + reach + swing, kLegs.foot_up + lift);
      Vec3 knee = 0.5f * (hip + foot) + Vec3(side * kLegs.knee_aside, 0, kLegs.knee_up);
      add_rod(s, hip, knee, kLegs.hip_radius, kLegs.knee_radius);
      add_rod(s, knee, foot, kLegs.knee_radius, kLegs.foot_radius);
    }
  }
  set_normals(s);
  return s;
}

/// A mesh with y up that faces +z, as an organ lies: along +y, its upper side +z.
Surface lying(Surface mesh) {
  auto turn = [](Vec3& p) { p = {-p.x, p.z, p.y}; };
  std::ranges::for_each(mesh.position, turn);
  std::ranges::for_each(mesh.normal, turn);
  mesh.uv.clear();
  return mesh;
}

/// Where a path leads at a time.
struct PathPoint {
  Vec3 place, normal, heading;
  float along;  // metres
};

/// What is on it is `size` long: the normal is the mean below it, so that it turns over an edge as it comes
/// over it.
PathPoint point_on(const Strands& paths, const Strand& path, float time, float size) {
  const Skeleton& s = paths.skeleton;
  auto begin = s.birth.begin() + path.first, end = begin + path.count;
  auto next = static_cast<std::int32_t>(std::upper_bound(begin, end, time) - s.birth.begin());
  std::int32_t last = path.first + path.count - 1;
  std::int32_t to = std::clamp(next, path.first + 1, last), from = to - 1;
  float span = s.birth[to] - s.birth[from];
  float share = span > 0 ? std::clamp((time - s.birth[from]) / span, 0.0f, 1.0f) : 1;
  PathPoint point{glm::mix(paths.contact[from], paths.contact[to], share), Vec3(0), Vec3(0),
                  glm::mix(s.distance[from], s.distance[to], share)};
  auto weigh = [&](std::int32_t i) {
    float weight = 1 - std::abs(s.distance[i] - point.along) / size;
    if (weight <= 0) return false;
    point.normal += weight * paths.normal[i];
    if (i > path.first) point.heading += weight * (paths.contact[i] - paths.contact[i - 1]);
    return true;
  };
  for (std::int32_t i = from; i >= path.first && weigh(i); --i) continue;
  for (std::int32_t i = to; i <= last && weigh(i); ++i) continue;
  if (glm::length(point.normal) < 1e-3f) point.normal = paths.normal[to];
  point.normal = glm::normalize(point.normal);
  return point;
}

/// The rotation that takes +y to a heading and +z to a normal, as far as they are at right angles.
Quat standing(Vec3 heading, Vec3 normal) {
  Vec3 ahead = heading - normal * glm::dot(heading, normal);
  if (glm::length(ahead) < 1e-9f)
    ahead = glm::cross(normal, std::abs(normal.x) < 0.9f ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
  ahead = glm::normalize(ahead);
  return glm::normalize(glm::quat_cast(glm::mat3(glm::cross(ahead, normal), ahead, normal)));
}

}  // namespace

std::vector<Prototype> walker_prototypes(const Walkers& walkers) {
  std::vector<Prototype> made;
  bool beetle = walkers.mesh.triangle.empty();
  for (int k = 0; k < (beetle ? kGaits : 1); ++k) {
    Prototype one{"walker", {}, walkers.colors, walkers.second};
    one.luster = Luster{0, walkers.gloss, 0};
    one.parts.push_back({Tissue::fruit, beetle ? beetle_back() : lying(walkers.mesh)});
    if (beetle) one.parts.push_back({Tissue::heart, beetle_limbs(static_cast<double>(k) / kGaits)});
    made.push_back(std::move(one));
  }
  return made;
}

Organs walkers_at(const Walkers& walkers, const Strands& paths, double share, Seed seed) {
  Organs organs;
  organs.reserve(paths.strands.size());
  for (std::size_t k = 0; k < paths.strands.size(); ++k) {
    Seed own = seed.child(k);
    double size = walkers.size * (1 + walkers.size_variation * own.child("size").range(-1, 1));
    PathPoint point = point_on(paths, paths.strands[k], static_cast<float>(share), static_cast<float>(size));
    double steps = static_cast<double>(point.along) / (kStride * size) + own.child("gait").unit();
    auto moment = static_cast<std::uint16_t>(static_cast<int>((steps - std::floor(steps)) * kGaits) % kGaits);
    organs.prototype.push_back(walkers.mesh.triangle.empty() ? moment : std::uint16_t{0});
    organs.position.push_back(point.place);
    organs.turn.push_back(standing(point.heading, point.normal));
    organs.scale.push_back(Vec3(static_cast<float>(size)));
    organs.node.push_back(Skeleton::kRoot);
    organs.birth.push_back(0);
    organs.color.push_back(static_cast<std::int32_t>(own.child("color").bits() % walkers.colors.size()));
    organs.id.push_back(static_cast<std::uint32_t>(k));
  }
  return organs;
}

}  // namespace frond
