#pragma once

#include "creeping/crawl.h"

namespace frond {

/// Wind in which hanging strands swing.
struct Breeze {
  double amplitude = 0.15;     ///< radians that a free end turns aside
  Vec3 direction{1, 0, 0.3f};  ///< of the wind; its vertical part is ignored
  double phase = 0;            ///< radians
  double film_length = 0;      ///< seconds after which it all repeats; 0: it never does
};

/// Where the strands are in the wind at a time, and by what each node is turned from its rest: a pure
/// function of its arguments, so that any moment can be made alone. Segments keep their lengths; nodes that
/// hold the surface stay where they are. A free end swings as a heavy chain does, by its two slowest modes
/// (Bernoulli 1738), a length that took hold again turns about the line between its ends; neither farther
/// than it has room before the host. `position` and `turn` are overwritten.
void swing_strands(const Strands& strands, const Breeze& breeze, double time, std::vector<Vec3>& position,
                   std::vector<Quat>& turn);

}  // namespace frond
