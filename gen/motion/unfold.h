#pragma once

#include <functional>

#include "model/model.h"
#include "motion/motion.h"

namespace frond {

/// How large an organ is at a pose, as a share of its final size: 0 before growth has reached its birth, then
/// eased to 1 over `ripen` of the growth.
float unfolded(float birth, float front, double ripen);

inline constexpr float kUnfoldedLeast = 0.02f;  ///< share of its size below which an organ is not shown yet

/// The share of the growth in which a leaf unfolds.
inline double unfold_time(const Motion& motion) {
  return motion.unfold > 0 ? motion.unfold : motion.growth.ripen;
}

/// The turn, about axes of its own, by which a leaf at a place trembles on its stalk. Over the film it swings
/// a whole number of times, so that the film can be repeated. Each `id` has speeds and phases of its own.
Quat fluttering(const Flutter& flutter, double film_length, double time, Vec3 place, std::uint32_t id,
                float supple);

/// How young the skin at node `i` is, 1 at a tip, grown or growing .. 0 from `young_length` metres below it
/// on; `longest` is that of the skeleton.
float youth(const Skeleton& rest, const Pose& pose, float longest, float young_length, std::int32_t i);

/// A place on the rest shape that rides on a node, where the pose has taken it.
inline Vec3 carried(const Skeleton& rest, const Pose& pose, std::int32_t node, Vec3 at) {
  return node == Skeleton::kRoot ? at : pose.position[node] + pose.turn[node] * (at - rest.position[node]);
}

/// How an organ or a blade on a node is turned.
inline Quat carried_turn(const Pose& pose, std::int32_t node) {
  return node == Skeleton::kRoot ? Quat(1, 0, 0, 0) : pose.turn[node];
}

/// Where an organ is at a pose, and how it is turned: as its node, the less the looser it is.
Vec3 organ_place(const Skeleton& rest, const Pose& pose, const Organs& organs, std::size_t i);
Quat organ_turn(const Pose& pose, const Organs& organs, std::size_t i);

/// The prototypes, and the organs that are there when `front` is reached, as a pose has them; those that it
/// has not reached are all but nothing. They ride on no node any more.
Model posed_organs(const Model& model, const Pose& pose, double ripen, float front);

/// The blades that are wanted and at least so far unfolded, carried to where the pose has them, as one mesh.
Surface posed_blades(const Skeleton& rest, const Pose& pose, const Blades& blades, double ripen,
                     const std::function<bool(std::size_t blade)>& wanted, float least = kUnfoldedLeast);

}  // namespace frond
