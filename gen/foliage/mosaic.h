#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace frond {

/// A round patch of leaf.
struct Disc {
  Vec3 middle{0};
  Vec3 normal{0, 0, 1};  ///< of length 1, out of the upper side
  float radius = 0.5f;
};

/// What may be put at a site: a leaf on its petiole, or a sprig of several, as discs. Its foot is at the
/// origin, it points along +y, its upper side is toward +z; about one unit long.
struct LeafForm {
  std::vector<Disc> discs;
};

/// Where a leaf may grow. Metres.
struct MosaicSite {
  Vec3 foot{0};
  Vec3 normal{0, 0, 1};      ///< that the upper side would best have: to the light, away from the wall
  Vec3 tip{0, -1, 0};        ///< where it would best point; need not be tangent
  float size = 0.05f;        ///< metres, of one unit of the form
  std::uint32_t first = 0;   ///< of the forms to choose from
  std::uint32_t forms = 1;   ///< how many of them
  std::uint32_t prefer = 0;  ///< which of them is tried first
};

/// A leaf in its place.
struct LaidLeaf {
  std::uint32_t site = 0, form = 0;
  Quat turn{1, 0, 0, 0};
  float covered = 0;  ///< share of its discs that lies under or over earlier ones
};

struct MosaicOptions {
  double overlap = 0.3;  ///< share of a leaf that others may cover; what finds no such place does not grow
  double swing = radians(70.0);  ///< how far a leaf's tip may be turned aside for a free place
  int turns = 7;                 ///< directions that are tried within that
  double depth = 3;              ///< radii of a leaf within which another one before or behind it counts
  std::size_t most = SIZE_MAX;   ///< no more leaves are laid
};

/// Lays leaves into the gaps that earlier ones have left, as a shoot does that turns its petioles until each
/// blade has its own patch of light (the leaf mosaic of Kerner 1895). The sites are gone through in order; at
/// each the form and the direction that are covered least are taken, the preferred ones first among equals.
/// Leaves are compared as discs, seen along the normal, through a grid: cost linear in their number.
std::vector<LaidLeaf> lay_leaves(std::span<const MosaicSite> sites, std::span<const LeafForm> forms,
                                 const MosaicOptions& options);

/// The turn that takes a form's axes to upper side `normal` and, as nearly as that lets it, `tip`.
Quat leaf_turn(Vec3 normal, Vec3 tip);

/// The area that two circles have in common, to 1e-7 of the square of the larger radius: more than its float
/// users can tell.
double lens_area(double radius, double other, double distance);

}  // namespace frond
