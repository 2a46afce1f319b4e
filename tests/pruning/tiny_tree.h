#pragma once

#include "model/model.h"

namespace frond {

inline constexpr std::int32_t kLowBranch = 5, kHighBranch = 11, kTwig = 8;

/// A stem of four metres (nodes 0 to 4) with two branches, of which the lower one bears a twig.
inline Skeleton tiny_tree() {
  Skeleton s;
  s.add(Vec3(0), 0.1f, Skeleton::kRoot, 0);
  for (int i = 1; i <= 4; ++i) s.add(Vec3(0, i, 0), 0.1f - 0.015f * static_cast<float>(i), i - 1, 0);
  std::int32_t below = 1;
  for (float i = 1; i <= 3; ++i) below = s.add(Vec3(0.6f * i, 1 + 0.1f * i, 0), 0.04f, below, 1);
  below = 6;
  for (float i = 1; i <= 3; ++i) below = s.add(Vec3(1.2f, 1.2f + 0.2f * i, 0.1f * i), 0.01f, below, 2);
  below = 3;
  for (float i = 1; i <= 3; ++i) below = s.add(Vec3(-0.5f * i, 3 + 0.2f * i, 0), 0.03f, below, 1);
  set_tip_distances(s);
  set_births(s);
  return s;
}

/// The same with an organ at each node and a blade on the twig.
inline Model tiny_model() {
  Model m;
  m.skeleton = tiny_tree();
  Prototype leaf{"leaf", {}, {Color{}}, Color{}};
  m.prototypes.push_back(leaf);
  for (std::size_t i = 1; i < m.skeleton.size(); ++i) {
    Organs& o = m.organs;
    o.prototype.push_back(0);
    o.position.push_back(m.skeleton.position[i] + Vec3(0, 0.01f, 0));
    o.turn.push_back(Quat(1, 0, 0, 0));
    o.scale.push_back(Vec3(0.05f));
    o.node.push_back(static_cast<std::int32_t>(i));
    o.birth.push_back(m.skeleton.birth[i]);
    o.color.push_back(0);
    o.id.push_back(static_cast<std::uint32_t>(i));
  }
  Blades& b = m.blades;
  b.node = {kTwig + 1}, b.birth = {0}, b.color = {0}, b.id = {1};
  b.foot = {m.skeleton.position[kTwig + 1]};
  b.first.push_back(3);
  b.surface.position = {b.foot[0], b.foot[0] + Vec3(0.1f, 0, 0), b.foot[0] + Vec3(0, 0.1f, 0)};
  b.surface.normal.assign(3, Vec3(0, 0, 1));
  b.surface.triangle = {{0, 1, 2}};
  return m;
}

}  // namespace frond
