#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/skeleton.h"
#include "model/surface.h"

namespace frond {

/// How branches become tubes.
struct TubeShape {
  double wrap = 0.5;      ///< metres round a branch covered by one width of the picture
  double aspect = 2;      ///< height of the picture relative to its width
  double side = 0.03;     ///< metres, about the width of a facet; twigs have 3 at least
  int most_sides = 48;    ///< of the thickest, 3 or more
  int lobes = 0;          ///< of the cross-section of branches of order 0
  double lobe_depth = 0;  ///< share of the radius
  float least = 0;        ///< metres; branches that begin thinner than this are skipped
  double grain = 0;  ///< metres: facets and nodes are left out as far as they keep within a quarter of it
  std::span<const float> girth = {};  ///< metres, of each node: final radius that the picture fits while the
                                      ///< branch still thickens; empty: its own
};

/// For each node, whether its branch is skipped.
std::vector<bool> left_out(const Skeleton& rest, const TubeShape& shape);

/// Turns every branch into a tube: each chain of the skeleton is one, starting inside its parent. `uv` goes a
/// whole number of times round the branch, constant along it, so that the only seam is where 0 meets 1; along
/// the branch it follows the length of the rest shape without a break, so that the picture sticks to a moving
/// branch. `position`, `radius` and `turn` are those of a pose, one per node; `turn` rotates the rest shape
/// round a node to the posed one.
Surface tube_surface(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
                     std::span<const Quat> turn, const TubeShape& shape);

/// The tubes of a skeleton at rest, as the other tube_surface() makes them.
Surface tube_surface(const Skeleton& rest, const TubeShape& shape);

/// Branches as tubes, with the node of each vertex.
struct TubeMesh {
  Surface surface;                 ///< `uv` of closed tubes: once round the branch, and metres along it
  std::vector<std::int32_t> node;  ///< of each vertex: the node of its ring; where it leaves a fork, the next
};

/// The tubes of tube_surface(), with the node of each vertex.
TubeMesh tube_mesh(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
                   std::span<const Quat> turn, const TubeShape& shape);

/// Each branch of a skeleton as one closed tube with a rounded end, smooth and with minimal twist. `position`
/// and `radius` have one entry per node; nodes born after `front` are skipped. `sides` is 3 or more; with
/// `grain`, metres, branches have fewer sides if these stay within a quarter of it. Triangles are closed when
/// vertices at equal positions are merged.
TubeMesh closed_tubes(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
                      float front, int sides, float grain = 0);

}  // namespace frond
