#pragma once

#include "grove/grove.h"

namespace frond {

/// The parts of a tree that exist at one time: living, dead, falling; one entry per internode, parents first.
struct Standing {
  std::vector<std::uint32_t> source;  ///< index into the grown tree
  std::vector<Vec3> tip, side;        ///< metres; of falling parts, their present position
  std::vector<std::int32_t> parent;   ///< index in here, or GrownTree::kRoot
  std::vector<Vec3> foot;             ///< the lower end; of a fallen piece it differs from the parent's tip
  std::vector<float> radius;
  std::vector<float> leaves;  ///< 0 bare .. 1 in full leaf

  std::size_t size() const { return source.size(); }
};

struct Filming {
  double seconds_a_year = 1;  ///< seconds of film per year; falling takes place in film time
  double lie = 1.2;           ///< seconds after which a fallen part has disappeared
  double overtime = 0;        ///< seconds since the years stopped, in which only falling parts move
  double leafy = 0;           ///< seconds for which an uprooted tree keeps its leaves, and then withers
};

/// The tree at a time in years, which may be fractional: shoots lengthen, the cross-section of wood grows
/// evenly from one ring to the next, leaves unfold, wither and fall, broken pieces tip over, fall and sink
/// into the ground. Continuous in time. Without history always the final tree.
Standing standing(const GrownTree& tree, const Species& species, double year, const Filming& filming);

}  // namespace frond
