#pragma once

#include <functional>
#include <vector>

#include "core/vec.h"
#include "motion/motion.h"

// How a tree that lost its balance falls: a rigid body that turns about one edge of its root plate.

namespace frond {

/// The moments on a body that turns about a level or sloping hinge, by the angle that it has turned:
/// its weight's, N m, is weight sin(angle - balance). What is left besides, of the gust less the roots,
/// begins so that the sum is `excess`, and is gone at the angle `torn`, in proportion to the angle (Coutts
/// 1986: the roots of an overturned spruce break one after the other while the plate is lifted).
struct Overturning {
  double inertia = 1;     ///< kg m2, about the hinge
  double weight = 0;      ///< N m, of the weight where its lever is longest
  double balance = 0;     ///< radians, where the centre of mass is above the hinge
  double excess = 0;      ///< N m, by which the load passes what the roots hold, > 0
  double torn = 0.3;      ///< radians
  double stop = kPi / 2;  ///< radians, where it hits the ground
};

inline constexpr double kFallStep = 1.0 / 120;  ///< seconds between the angles of a course

/// The angle at each step from rest until it is at rest again: inertia x angle'' = moment_at(angle), by Runge
/// and Kutta's fourth order. The ground gives back a fifth of the speed, so the body settles in a few small
/// rebounds. It stops short of the ground where the roots bring it to rest.
std::vector<float> course_of(const Overturning& body);

/// The fall of one tree.
struct Fall {
  double start = 0;           ///< seconds
  Vec3 hinge{0};              ///< a place on the edge about which it turns, metres
  Vec3 axis{0, 0, 1};         ///< of the turn, of length 1, in the plane of the ground
  std::vector<float> course;  ///< radians at each kFallStep from `start`

  double length() const { return static_cast<double>(course.size()) * kFallStep; }  ///< seconds
  float angle(double time) const;
  /// The share of its swaying that is left: none once it falls.
  double sway(double time) const;
};

/// The height of the ground at x, z, metres.
using GroundHeight = std::function<double(double, double)>;

/// Turns a pose of `rest` as the tree has fallen by a time. What hangs together with the first node turns
/// rigidly; where that would push a branch below the ground, it bends at its nodes and lies on the ground,
/// all internodes as long as before. What lay below the ground at rest may do so again.
void turn_fallen(const Fall& fall, const Skeleton& rest, double time, const GroundHeight& ground, Pose& pose);

}  // namespace frond
