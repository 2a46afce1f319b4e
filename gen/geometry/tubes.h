#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/skeleton.h"
#include "model/surface.h"

namespace frond {

/// How branches become tubes.
struct TubeShape {
  double wrap = 0.5;      ///< metres round a branch that one picture is wide
  double aspect = 2;      ///< how much longer than wide the picture is
  double side = 0.03;     ///< metres, about the width of a facet; twigs have 3 at least
  int most_sides = 48;    ///< of the thickest, 3 or more
  int lobes = 0;          ///< of the cross-section of branches of order 0
  double lobe_depth = 0;  ///< share of the radius
  float least = 0;        ///< metres; branches that begin thinner than this are left out
  std::span<const float> girth =
      {};  ///< metres, of each node: the radius that the picture fits, of what still thickens; empty: its own
};

/// Whether the branch that a node is of is left out, of each node.
std::vector<bool> left_out(const Skeleton& rest, const TubeShape& shape);

/// Turns every branch into a tube: a chain of the skeleton is one, which begins inside of its parent. `uv`
/// goes a whole number of times round the branch, the same along all of it, so that it has no seam but the
/// one where 0 meets 1; along the branch it goes on without a break by the rest shape's length, so that the
/// picture sticks to a branch that moves. `position`, `radius` and `turn` are those of a pose, one a node;
/// `turn` takes the rest shape round a node to the posed one.
Surface tube_surface(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
                     std::span<const Quat> turn, const TubeShape& shape);

/// The same at rest.
Surface tube_surface(const Skeleton& rest, const TubeShape& shape);

/// Branches as tubes, and what they were made of.
struct TubeMesh {
  Surface surface;                 ///< `uv` of closed tubes: once round the branch, and metres along it
  std::vector<std::int32_t> node;  ///< of each vertex: the node of its ring; where it leaves a fork, the next
};

/// As tube_surface().
TubeMesh tube_mesh(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
                   std::span<const Quat> turn, const TubeShape& shape);

/// Each branch of a skeleton as one closed tube with a rounded end, smooth along it and twisted as little as
/// can be. `position` and `radius` have an entry a node; what is born after `front` is not there yet. `sides`
/// is 3 or more; with a `grain`, metres, branches have fewer where these keep within a quarter of it.
/// Triangles are closed where vertices at one place are one.
TubeMesh closed_tubes(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
                      float front, int sides, float grain = 0);

}  // namespace frond
