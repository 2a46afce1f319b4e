#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "crown/along.h"
#include "model/model.h"

// The shape of what has grown by other laws, changed by curves along the parent.

namespace frond {

/// How the axes that leave others of one depth change by the place on their parent, from its foot (0) to its
/// tip (1). All that an axis bears changes with it.
struct AlongParent {
  Curve angle = even_along();   ///< factor of the angle from the parent
  Curve length = even_along();  ///< factor of the length
  Curve radius = even_along();  ///< factor of the radius; an axis is no thicker than its parent there

  bool even() const { return is_even(angle) && is_even(length) && is_even(radius); }
};

/// How the branches on the stem change, and the twigs on these branches.
struct BranchesAlong {
  AlongParent branches, twigs;
  bool even() const { return branches.even() && twigs.even(); }
};

/// What becomes of the nodes of a plant.
struct ShapedAlong {
  std::vector<Vec3> position;
  std::vector<Quat> turn;             ///< rotation of what is attached to each node, about the node
  std::vector<float> length, radius;  ///< factors, of each node
};

/// The shape of a plant whose branches and twigs change as `by` says; the nodes, which have these axes, come
/// parents first. The angle of an axis is that between its chord, from where it leaves to its tip, and its
/// parent there. What belongs to no axis stays with its parent.
ShapedAlong shape_along(std::span<const std::int32_t> parent, std::span<const AxisNode> axes,
                        std::span<const Vec3> position, std::span<const float> radius,
                        const BranchesAlong& by);

}  // namespace frond
