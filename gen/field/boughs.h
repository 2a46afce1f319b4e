#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "field/cone.h"
#include "model/skeleton.h"

namespace frond {

inline constexpr std::size_t kMostArms = 8;      ///< of one fork
inline constexpr std::uint32_t kMostCones = 32;  ///< of one arm
inline constexpr std::size_t kMostMembers = kMostArms * kMostCones;

/// One way that leads away from a fork: the cones that are met on it first.
struct Arm {
  std::uint32_t first, last;  ///< in Forks::member, last not included
  float width;                ///< metres, how far it flows into others at most
};

/// Forks, and the arms that are blended into each other at each.
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

/// The branches of one or several skeletons as a solid body: cones, and forks at which they flow into each
/// other. Branches that only pass each other by do not: they are joined, but with a crease.
struct Boughs {
  std::vector<Cone> cones;
  Forks forks;
};

/// What of the boughs counts in some ball: cones by index, and forks that are held to what is near.
struct Nearby {
  std::vector<std::uint32_t> cones;
  Forks forks;
  float middle = 0;  ///< the distance of the nearest cone from the middle of the ball
};

/// Adds the branches of a skeleton, as they stand at a pose. `position` and `radius` have an entry a node;
/// segments whose lower node is born at `front` or later are not there yet. The `node` of the cones counts
/// from `first_node` on.
///
/// `blend` says how far fillets at forks reach, as a share of the radius of the thinner arm: 0 leaves a
/// crease, 1 rounds it about as wide as that arm is thick.
void add_boughs(Boughs& boughs, const Skeleton& rest, std::span<const Vec3> position,
                std::span<const float> radius, float front, float blend, std::int32_t first_node = 0);

/// The same with no branch thinner than that; metres.
Boughs at_least_as_thick(const Boughs& boughs, float radius);

/// The same for a skeleton as it rests, fully grown.
Boughs boughs_of(const Skeleton& rest, float blend);

/// Where the body is, near one place.
struct FieldSample {
  float distance;     ///< metres from the surface, negative inside; exact but for the fillets
  Vec3 normal;        ///< the direction in which the distance grows, of length 1
  std::int32_t cone;  ///< the nearest
};

/// Everything, as if it were all near.
Nearby all_of(const Boughs& boughs);

/// Of what is near in a larger ball, what makes a difference to the distance in a ball of radius `half` round
/// `at`, as far as that distance is within `band`. `to` is overwritten.
void choose_near(const Boughs& boughs, const Nearby& from, Vec3 at, float half, float band, Nearby& to);

/// Whether a fork makes such a difference; adds it to `to` where one is given.
bool choose_fork(const Boughs& boughs, const Forks& from, std::size_t fork, Vec3 at, float half, float band,
                 Forks* to);

/// Where the body is, by what is near.
FieldSample sample_boughs(const Boughs& boughs, const Nearby& near, Vec3 at);

/// How far the fillets of a fork push the surface out at most; metres.
float fillet_reach(const Forks& forks, std::size_t fork);

/// The nearest cone of an arm at some place.
struct Nearest {
  float distance;
  std::uint32_t cone;
};

/// The distance at a fork, of whose arms, in their order, the nearest cones are known there. The normal is
/// only set where it is asked for.
FieldSample blend_arms(const Boughs& boughs, const Forks& forks, std::size_t fork,
                       std::span<const Nearest> arms, Vec3 at, bool with_normal);

}  // namespace frond
