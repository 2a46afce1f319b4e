#pragma once

#include <vector>

#include "draw/organs.h"
#include "draw/twig_plan.h"
#include "motion/unfold.h"
#include "scene/copies.h"

// The twigs of a plant at one time, as copies of a palette.

namespace frond {

/// A mesh of a twig of the palette with one look: its wood, without `uv`, or the organs of one prototype's
/// part, whose `uv` are as of CopyPart, with k below twig_numbers(). The joint lies at the origin, and the
/// axes are those of the plant at rest.
struct TwigPart {
  CopyPart::Kind kind = CopyPart::Kind::wood;
  std::size_t which = 0;  ///< an organ's prototype
  std::size_t part = 0;   ///< of the prototype
  Surface surface;
};

/// How many leaves of so many colours a texture tells apart: leaf k has the colour k modulo their number, and
/// the shade is how often that goes into k.
inline std::size_t twig_numbers(std::size_t colors) { return kLeafShades * colors; }

/// The twigs of a plant in a pose. A twig of the palette moves as the one that it is does, and is carried to
/// each of its places as the first node there is turned.
struct DrawnTwigs {
  DrawnTwigs(const TwigPlan& plan, const Specimen& plant, const Pose& pose, double time);

  const TwigPlan& plan;
  std::vector<std::vector<TwigPart>> shapes;  ///< of each of the palette
  std::vector<OrganPlace> places;             ///< of each place of the plan

  /// Metres that one of the palette reaches from its joint.
  double reach() const;
};

/// The pose of the limbs that are left.
Pose pose_of_limbs(const TwigPlan& plan, const Pose& pose);

}  // namespace frond
