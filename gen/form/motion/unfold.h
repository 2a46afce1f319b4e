#pragma once

#include <functional>

#include "model/model.h"
#include "motion/motion.h"

namespace frond {

/// Size of an organ in a pose, relative to its final size: 0 before growth reaches its birth, then eased to 1
/// over `ripen` of the growth.
float unfolded(float birth, float front, double ripen);

inline constexpr float kUnfoldedLeast = 0.02f;  ///< relative size below which an organ is not shown

/// The share of the growth in which a leaf unfolds.
inline double unfold_time(const Motion& motion) {
  return motion.unfold > 0 ? motion.unfold : motion.growth.ripen;
}

/// The rotation of a fluttering leaf on its stalk, in its own axes. An integer number of swings fits in the
/// film, so that it can be repeated. Speed and phase depend on `id`.
Quat fluttering(const Flutter& flutter, double film_length, double time, Vec3 place, std::uint32_t id,
                float supple);

/// How young the skin at node `i` is: 1 at a tip .. 0 at `young_length` metres below it and farther;
/// `longest` is that of the skeleton.
float youth(const Skeleton& rest, const Pose& pose, float longest, float young_length, std::int32_t i);

/// The posed position of a point of the rest shape that is attached to a node.
inline Vec3 carried(const Skeleton& rest, const Pose& pose, std::int32_t node, Vec3 at) {
  return node == Skeleton::kRoot ? at : pose.position[node] + pose.turn[node] * (at - rest.position[node]);
}

/// The rotation of an organ or blade on a node.
inline Quat carried_turn(const Pose& pose, std::int32_t node) {
  return node == Skeleton::kRoot ? Quat(1, 0, 0, 0) : pose.turn[node];
}

/// Where an organ is: takes a shape's axes to the world's; metres.
struct OrganPlace {
  Vec3 at;
  Quat turn;  ///< of length 1
  Vec3 scale;
};
/// The place of organ `i` of a model in a pose at a time, with its flutter; `size` is a factor. The looser
/// the organ is, the less it follows its node.
OrganPlace organ_place(const Model& model, const Motion& motion, const Pose& pose, double time, std::size_t i,
                       float size);

/// The prototypes, and as posed the organs that `front` reaches; those that the pose has not reached have a
/// size near 0. The organs are no longer attached to nodes.
Model posed_organs(const Model& model, const Motion& motion, const Pose& pose, double time, float front);

/// The selected blades that have unfolded at least that far, posed, as one mesh.
Surface posed_blades(const Skeleton& rest, const Pose& pose, const Blades& blades, double ripen,
                     const std::function<bool(std::size_t blade)>& wanted, float least = kUnfoldedLeast);

}  // namespace frond
