#pragma once

#include "grove/grove.h"

namespace frond {

/// What of a tree there is at one time: living, dead, falling; an entry an internode, parents first.
struct Standing {
  std::vector<std::uint32_t> source;  ///< index into the grown tree
  std::vector<Vec3> tip, side;        ///< metres; of what falls, where it is by now
  std::vector<std::int32_t> parent;   ///< index in here, or GrownTree::kRoot
  std::vector<Vec3> foot;             ///< the lower end; of a fallen piece no longer that of its parent
  std::vector<float> radius;
  std::vector<float> leaves;  ///< 0 bare .. 1 in full leaf

  std::size_t size() const { return source.size(); }
};

struct Filming {
  double seconds_a_year = 1;  ///< of the film; what falls falls by the film's clock
  double lie = 1.2;           ///< seconds after which what has fallen has gone
  double overtime = 0;        ///< seconds since the years stood still, in which only what falls moves
};

/// The tree at a time in years, between the years too: shoots lengthen, the area of wood grows evenly from
/// one ring to the next, leaves unfold, wither and fall, broken pieces tip over, fall and sink away.
/// Continuous in time. Without history the tree is as it ended, whatever the year.
Standing standing(const GrownTree& tree, const Species& species, double year, const Filming& filming);

}  // namespace frond
