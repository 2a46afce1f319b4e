#include "draw/polyps.h"

#include <algorithm>
#include <cmath>

#include "core/cell_grid.h"
#include "draw/solids.h"

namespace frond {

namespace {

constexpr double kApart = 0.85;        // of their width: how near polyps stand to each other
constexpr float kSeen = 2, kGone = 1;  // pixels that one is wide
/// The seed of the lots that turn and size polyps: polyps of one number are alike on all corals.
constexpr Seed kPolypLots{77};
constexpr double kYoung = 0.06;  // of the growth, after which a place bears its polyp

/// Whether what was at a place of the grown skin is dead.
bool is_dead(const std::vector<DeadPatch>& dead, Vec3 at) {
  return std::ranges::any_of(dead, [&](const DeadPatch& d) { return glm::distance(d.at, at) < d.radius; });
}

/// Places of the grown skin that are alive and at least so far apart.
std::vector<SurfacePoint> spots_of(const Surface& skin, const std::vector<DeadPatch>& dead, float apart) {
  std::vector<SurfacePoint> spots;
  Darts darts(apart);
  for (const auto& t : skin.triangle) {
    Vec3 a = skin.position[t[0]], b = skin.position[t[1]], c = skin.position[t[2]];
    float side = std::max(glm::distance(a, b), std::max(glm::distance(b, c), glm::distance(c, a)));
    auto n = static_cast<int>(std::clamp(side / (0.5f * apart), 1.0f, 40.0f));
    for (int u = 0; u < n; ++u)
      for (int v = 0; u + v < n; ++v) {
        Vec2 at = (Vec2(u, v) + 1.0f / 3.0f) / static_cast<float>(n);
        SurfacePoint spot{t, Vec3(1 - at.x - at.y, at.x, at.y)};
        Vec3 place = spot.of(skin.position);
        if (!is_dead(dead, place) && darts.try_add(place)) spots.push_back(spot);
      }
  }
  return spots;
}

double grown_since(double born, double front) { return smooth_step(born, born + kYoung, front); }

}  // namespace

void DrawnPolyps::add(std::size_t n, Vec3 at, Vec3 normal, double grown) {
  Seed own = kPolypLots.child(n);
  auto size = static_cast<float>(polyps->width * own.child(0).range(0.8, 1.15) * grown);
  Vec3 to_eye = eye.at - at;
  float distance = glm::length(to_eye);
  size *= smooth_step(kGone, kSeen, size / (static_cast<float>(eye.pixel) * distance));
  if (!(size > 0) || glm::dot(normal, to_eye) < -0.35f * distance) return;
  Quat turn = Quat(Vec3(0, 1, 0), normal) *
              glm::angleAxis(static_cast<float>(own.child(1).range(0, 2 * kPi)), Vec3(0, 1, 0));
  frames.push_back(glm::mat3_cast(turn) * size);
  positions.push_back(at);
}

PolypPlaces polyp_places(const Solids& solids) {
  PolypPlaces places(solids.size());
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Solid& solid = solids.shapes[solids.shape[i]];
    if (double width = solid.material.polyps.width; width > 0)
      places[i] = spots_of(solid.surface, solid.material.dead, static_cast<float>(kApart * width));
  }
  return places;
}

std::vector<DrawnPolyps> drawn_polyps(const Solids& solids, const PolypPlaces& places, const Growth& growth,
                                      double time, const Eye& eye) {
  std::vector<DrawnPolyps> all;
  each_grown_skin(
      solids, places, growth, time, [&](std::size_t i, const Solid& solid, const Surface& skin, float front) {
        DrawnPolyps& polyps =
            all.emplace_back(DrawnPolyps{&solid.material.polyps, solid.material.color, eye});
        for (std::size_t n = 0; n < places[i].size(); ++n) {
          const SurfacePoint& spot = places[i][n];
          double born = solid.surface.uv.empty() ? 0 : static_cast<double>(spot.of(solid.surface.uv).y);
          polyps.add(n, solids.placed(i, spot.of(skin.position)),
                     solids.turn[i] * direction_or(spot.of(skin.normal), Vec3(0, 1, 0)),
                     grown_since(born, static_cast<double>(front)));
        }
      });
  return all;
}

DrawnPolyps drawn_polyps(const DrawnBranches& branches, const Eye& eye) {
  const Skeleton& rest = branches.rest();
  const Pose& pose = branches.pose;
  const Polyps& polyps = *branches.look().polyps();
  DrawnPolyps drawn{&polyps, branches.look().skin->tint.base, eye};
  auto apart = static_cast<float>(kApart * polyps.width);
  std::size_t n = 0;
  float along = 0;  // metres of the branch since the last one
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest.parent[i] == Skeleton::kRoot) continue;
    auto below = static_cast<std::size_t>(rest.parent[i]);
    Vec3 axis = rest.position[i] - rest.position[below];
    float length = glm::length(axis), radius = rest.radius[i];
    if (length <= 0) continue;
    axis /= length;
    Vec3 side = glm::normalize(glm::cross(axis, reference_axis(axis)));
    Vec3 other = glm::cross(axis, side);
    // As many as have room round the branch: one each so far along it.
    float pitch = std::min(apart, 0.87f * apart * apart / (2 * static_cast<float>(kPi) * radius));
    auto add = [&](float share, Vec3 out, float lift) {
      double born = static_cast<double>(glm::mix(rest.birth[below], rest.birth[i], share));
      Vec3 at = glm::mix(pose.position[below], pose.position[i], share);
      Vec3 normal = pose.turn[i] * out;
      drawn.add(n++, at + normal * (lift * glm::mix(pose.radius[below], pose.radius[i], share)), normal,
                grown_since(born, static_cast<double>(pose.front)));
    };
    for (; along < length; along += pitch) {
      float turn = static_cast<float>(kGoldenAngle) * static_cast<float>(n);
      add(along / length, glm::normalize(std::cos(turn) * side + std::sin(turn) * other + 0.35f * axis),
          0.97f);
    }
    along -= length;
    if (rest.to_tip[i] <= 0) add(1, axis, 1);
  }
  return drawn;
}

}  // namespace frond
