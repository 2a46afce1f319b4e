#include "organisms/ivy/walkers.h"

#include <algorithm>
#include <cmath>

#include "foliage/organ_shapes.h"

namespace frond {

namespace {

constexpr int kGaits = 8;       // shapes of a step
constexpr double kStep = 0.45;  // of its length that a beetle comes forward in one

/// Adds a ball of these half axes about a middle, nothing of it below `lowest`.
void add_ellipsoid(Surface& to, Vec3 middle, Vec3 half, float lowest) {
  Surface ball = ball_surface();
  auto first = static_cast<std::uint32_t>(to.position.size());
  for (const Vec3& p : ball.position) {
    Vec3 at = middle + 2.0f * half * p;
    to.position.push_back({at.x, at.y, std::max(at.z, lowest)});
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

/// Wing covers, and the shield before them. It heads for +y, its upper side is +z.
Surface beetle_back() {
  Surface s;
  add_ellipsoid(s, {0, -0.11f, 0.16f}, {0.24f, 0.36f, 0.19f}, 0.10f);
  // The seam between the wing covers.
  for (Vec3& p : s.position) p.z -= 0.02f * std::exp(-(p.x * p.x) / 0.0008f);
  add_ellipsoid(s, {0, 0.24f, 0.15f}, {0.18f, 0.13f, 0.12f}, 0.09f);
  set_normals(s);
  return s;
}

/// Head, feelers and legs at a moment 0..1 of the gait: three legs stand while the other three step.
Surface beetle_limbs(double moment) {
  Surface s;
  add_ellipsoid(s, {0, 0.39f, 0.13f}, {0.11f, 0.10f, 0.08f}, 0.07f);
  add_ellipsoid(s, {0, 0.02f, 0.12f}, {0.17f, 0.36f, 0.05f}, 0.07f);
  for (float side : {-1.0f, 1.0f}) {
    Vec3 elbow(side * 0.15f, 0.56f, 0.20f);
    add_rod(s, {side * 0.06f, 0.46f, 0.15f}, elbow, 0.012f, 0.010f);
    add_rod(s, elbow, {side * 0.24f, 0.72f, 0.14f}, 0.012f, 0.006f);
    for (int leg = 0; leg < 3; ++leg) {
      bool odd = (leg == 1) != (side > 0);
      double turn = 2 * kPi * (moment + (odd ? 0.5 : 0));
      auto swing = static_cast<float>(0.5 * kStep * 0.5 * std::cos(turn));
      auto lift = static_cast<float>(std::max(0.0, -std::sin(turn)) * 0.06);
      float from = 0.24f - 0.2f * static_cast<float>(leg), reach = 0.16f - 0.2f * static_cast<float>(leg);
      Vec3 hip(side * 0.12f, from, 0.11f), foot(side * 0.46f, from + reach + swing, 0.01f + lift);
      Vec3 knee = 0.5f * (hip + foot) + Vec3(side * 0.06f, 0, 0.14f);
      add_rod(s, hip, knee, 0.026f, 0.02f);
      add_rod(s, knee, foot, 0.02f, 0.01f);
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
    double steps = static_cast<double>(point.along) / (kStep * size) + own.child("gait").unit();
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
