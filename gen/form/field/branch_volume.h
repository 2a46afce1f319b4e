#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "field/round_cone.h"
#include "model/skeleton.h"

namespace frond {

inline constexpr std::size_t kMostArms = 8;      ///< of one fork
inline constexpr std::uint32_t kMostCones = 32;  ///< of one arm
inline constexpr std::size_t kMostMembers = kMostArms * kMostCones;

/// One branch that leaves a fork: its cones up to a limit, nearest first.
struct Arm {
  std::uint32_t first, last;  ///< in Forks::member, last not included
  float width;                ///< metres, largest width of its blend into other arms
};

/// Forks, and the arms that are blended together at each.
struct Forks {
  struct Fork {
    std::uint32_t first, last;  ///< in `arms`, last not included
  };
  std::vector<Fork> forks;
  std::vector<Arm> arms;
  std::vector<std::uint32_t> member;  ///< indices of cones, arm by arm

  std::size_t size() const { return forks.size(); }
  void clear() { forks.clear(), arms.clear(), member.clear(); }
};

/// The branches of one or more skeletons as a solid body: cones, and forks where they blend. Branches that
/// only touch are united too, but with a crease.
struct BranchVolume {
  std::vector<RoundCone> cones;
  Forks forks;
};

/// The part of the boughs that matters in a ball: indices of cones, and forks reduced to what is near.
struct Nearby {
  std::vector<std::uint32_t> cones;
  Forks forks;
  float middle = 0;  ///< distance of the nearest cone from the middle of the ball
};

/// Adds the branches of a skeleton in a pose. `position` and `radius` have one entry per node; segments whose
/// lower node is born at `front` or later are skipped. The `node` of the cones starts at `first_node`.
///
/// `blend` is the extent of fillets at forks, as a share of the radius of the thinner arm: 0 leaves a crease,
/// 1 makes a fillet about as wide as that arm is thick.
void add_boughs(BranchVolume& boughs, const Skeleton& rest, std::span<const Vec3> position,
                std::span<const float> radius, float front, float blend, std::int32_t first_node = 0);

/// A copy of the branches, none of them thinner than a radius in metres.
BranchVolume at_least_as_thick(const BranchVolume& boughs, float radius);

/// The branches of a fully grown skeleton at rest; `blend` as for add_boughs().
BranchVolume boughs_of(const Skeleton& rest, float blend);

/// The surface near a point.
struct FieldSample {
  float distance;     ///< metres from the surface, negative inside; exact except in fillets
  Vec3 normal;        ///< gradient of the distance, of length 1
  std::int32_t cone;  ///< the nearest
};

/// All cones and forks, as if they were near.
Nearby all_of(const BranchVolume& boughs);

/// From the items near a larger ball, those that affect the distance in a ball of radius `half` round `at`,
/// as far as that distance is within `band`. `to` is overwritten.
void choose_near(const BranchVolume& boughs, const Nearby& from, Vec3 at, float half, float band, Nearby& to);

/// Whether a fork has such an effect; adds it to `to` if given.
bool choose_fork(const BranchVolume& boughs, const Forks& from, std::size_t fork, Vec3 at, float half,
                 float band, Forks* to);

/// The surface near a point, from the items near it.
FieldSample sample_boughs(const BranchVolume& boughs, const Nearby& near, Vec3 at);

/// The farthest that the fillets of a fork push the surface out; metres.
float fillet_reach(const Forks& forks, std::size_t fork);

/// The nearest cone of an arm at a point.
struct Nearest {
  float distance;
  std::uint32_t cone;
};

/// The distance at a fork, given the nearest cones of its arms in their order. The normal is only set where
/// it is asked for.
FieldSample blend_arms(const BranchVolume& boughs, const Forks& forks, std::size_t fork,
                       std::span<const Nearest> arms, Vec3 at, bool with_normal);

}  // namespace frond
