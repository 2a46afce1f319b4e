#include "scene/put.h"

namespace frond {

namespace {

/// Turns, sizes and moves all but the skeleton from the origin to its place.
void put_parts(Branches& b, Vec3 foot, Quat turn, float size) {
  for (std::size_t i = 0; i < b.organs.size(); ++i) {
    b.organs.position[i] = foot + turn * (b.organs.position[i] * size);
    b.organs.turn[i] = glm::normalize(turn * b.organs.turn[i]);
    b.organs.scale[i] *= size;
  }
  for (std::size_t i = 0; i < b.solids.size(); ++i) {
    b.solids.position[i] = foot + turn * (b.solids.position[i] * size);
    b.solids.turn[i] = glm::normalize(turn * b.solids.turn[i]);
    b.solids.scale[i] *= size;
  }
  for (Vec3& p : b.hull.position) p = foot + turn * (p * size);
  for (Vec3& n : b.hull.normal) n = turn * n;
  for (Vec3& p : b.blades.foot) p = foot + turn * (p * size);
  for (Vec3& p : b.blades.surface.position) p = foot + turn * (p * size);
  for (Vec3& n : b.blades.surface.normal) n = turn * n;
}

/// The same for the skeleton.
void put_skeleton(Skeleton& s, Vec3 foot, Quat turn, float size) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    s.position[i] = foot + turn * (s.position[i] * size);
    s.radius[i] *= size;
    s.distance[i] *= size;
    s.to_tip[i] *= size;
  }
}

}  // namespace

void put(Branches& branches, Vec3 foot, Quat turn, float size) {
  put_skeleton(branches.rest, foot, turn, size);
  put_parts(branches, foot, turn, size);
}

void settle(Branches& branches, Model&& model, Vec3 foot, Quat turn, float size) {
  branches.rest = std::move(model.skeleton);
  branches.notes = std::move(model.notes);
  branches.color = std::move(model.color);
  branches.prototypes = std::move(model.prototypes);
  branches.organs = std::move(model.organs);
  branches.blades = std::move(model.blades);
  branches.solids = std::move(model.solids);
  branches.hull = std::move(model.hull);
  put(branches, foot, turn, size);
}

void follow_ground(Solids& solids, const Heights& ground, float foot_height) {
  if (!solids.follow_ground) return;
  for (Vec3& p : solids.position) p.y += static_cast<float>(ground(p.x, p.z)) - foot_height;
}

Surface skin_of(const Branches& branches) {
  return branches.hull.triangle.empty() ? merged(branches.solids) : branches.hull;
}

}  // namespace frond
