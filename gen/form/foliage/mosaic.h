#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace frond {

/// A disc that approximates a part of a leaf.
struct Disc {
  Vec3 middle{0};
  Vec3 normal{0, 0, 1};  ///< of length 1, out of the upper side
  float radius = 0.5f;
};

/// A form that may be placed at a site: a leaf on its petiole, or a sprig of several, as discs. Its foot is
/// at the origin, it points along +y, upper side toward +z; about one unit long.
struct LeafForm {
  std::vector<Disc> discs;
};

/// A possible position of a leaf. Metres.
struct MosaicSite {
  Vec3 foot{0};
  Vec3 normal{0, 0, 1};      ///< preferred normal of the upper side: to the light, away from the wall
  Vec3 tip{0, -1, 0};        ///< preferred direction of the tip; need not be tangent
  float size = 0.05f;        ///< metres per unit of the form
  std::uint32_t first = 0;   ///< index of the first form to choose from
  std::uint32_t forms = 1;   ///< number of forms to choose from
  std::uint32_t prefer = 0;  ///< index of the form that is tried first
};

/// A placed leaf.
struct LaidLeaf {
  std::uint32_t site = 0, form = 0;
  Quat turn{1, 0, 0, 0};
  float covered = 0;  ///< share of its discs that overlaps with earlier ones
};

struct MosaicOptions {
  double overlap = 0.3;  ///< share of a leaf that others may cover; a leaf without such a place is dropped
  double swing = radians(70.0);  ///< largest turn of a leaf's tip to find a free place
  int turns = 7;                 ///< number of directions tried within that
  double depth = 3;             ///< in radii of a leaf: others before or behind it count within this distance
  std::size_t most = SIZE_MAX;  ///< maximum number of leaves
};

/// Places leaves into the gaps left by earlier ones, as a shoot turns its petioles until each blade has its
/// own patch of light (the leaf mosaic of Kerner 1895). Sites are processed in order; each gets the form and
/// direction with the least overlap, the preferred ones first among equals. Leaves are compared as discs,
/// seen along the normal, through a grid: cost linear in their number.
std::vector<LaidLeaf> lay_leaves(std::span<const MosaicSite> sites, std::span<const LeafForm> forms,
                                 const MosaicOptions& options);

/// The rotation that takes a form's upper side to `normal` and its tip as near to `tip` as possible.
Quat leaf_turn(Vec3 normal, Vec3 tip);

/// The area common to two circles, to 1e-7 of the square of the larger radius, which is finer than float.
double lens_area(double radius, double other, double distance);

}  // namespace frond
