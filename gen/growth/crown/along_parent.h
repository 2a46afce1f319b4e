#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/curve.h"
#include "model/model.h"

// Curves along a parent, which say how what it bears changes from its foot (0) to its tip (1), and the shape
// of what has grown by other laws, changed by them.

namespace frond {

/// The curve of what does not change.
inline Curve even_along() { return Curve({{0, 1}, {1, 1}}); }

/// Whether a curve is 1 everywhere.
bool is_even(const Curve& curve);

/// The factor at a place, never negative; exactly 1 where the curve is even.
double factor_along(const Curve& curve, double place);

/// The mean factor between two places.
double mean_along(const Curve& curve, double from, double to);

/// The place between two others below which lies that share of what a density distributes there, 0..1.
double place_by_density(const Curve& density, double from, double to, double share);

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
