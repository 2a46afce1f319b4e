#pragma once

#include <span>
#include <vector>

#include "core/vec.h"
#include "grove/metamers.h"
#include "grove/species.h"

namespace frond {

/// Branches as a mechanical structure: parents precede children, an internode runs from its parent's end to
/// its own end. Metres.
struct Limbs {
  std::span<const Vec3> tip;
  std::span<const std::int32_t> parent;
  std::span<const float> radius;
  std::span<const float> leaf_area;  ///< square metres on each internode
};

/// The loads on branches besides their own weight.
struct Weather {
  Vec3 wind{0};     ///< metres a second, ten metres above the ground; weaker below
  double snow = 0;  ///< kg per square metre of ground below leaves and wood
};

/// The bending stress at the lower end of each internode, Pa: sigma = M r / I = 4 M / (pi r^3), from the
/// weight of wood, leaves and snow and the wind drag above it; 0 for entries without a parent.
std::vector<float> bending_stress(const Limbs& limbs, const Wood& wood, const Weather& weather);

/// The moment of all loads about the foot, N m: a level vector, at right angles to where they push the tree.
Vec3 moment_at_foot(const Limbs& limbs, const Wood& wood, const Weather& weather);

/// Recomputes the pipes of each internode, in units of a twig's: r^n = sum of r_i^n at forks, plus the pipes
/// of its own leaf along an axis (Shinozaki 1964, with Leonardo's n). Pipes of shed branches stay: radii
/// never decrease.
void thicken(Metamers& tree);

/// The pipes of one internode's own leaf, in units of a twig's.
inline constexpr float kLeafPipe = 0.15f;

/// The radius for that number of pipes, metres.
float pipe_radius(const Wood& wood, float pipe);

/// Bends this year's shoots, metamers `first` and after, under their weight: each internode by M l / (E I).
/// Older wood does not bend any more, nor a stem that is `tied`.
void sag(Metamers& tree, const Wood& wood, double leaf_area, std::size_t first, bool tied = false);

}  // namespace frond
