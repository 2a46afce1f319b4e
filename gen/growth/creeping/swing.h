#pragma once

#include "creeping/crawl.h"

namespace frond {

/// Wind in which hanging strands swing.
struct Breeze {
  double amplitude = 0.15;     ///< radians that a free end is turned aside, where `speed` is 0
  double speed = 0;            ///< metres a second, the mean; 0: no forces, see swing_strands()
  double gust = 3;             ///< metres from one gust to the next, > 0
  Vec3 direction{1, 0, 0.3f};  ///< of the wind; its vertical part is ignored
  double phase = 0;            ///< radians
  double film_length = 0;      ///< seconds after which the motion repeats; 0: it never does
};

/// A run of hanging nodes: `first` .. `last`, held by the parent of the first and, where it took hold again,
/// by the node after the last.
struct HangingRun {
  std::int32_t first, last;
  bool bridged;
};
std::vector<HangingRun> hanging_runs(const Strands& strands);

/// The strands in the wind at a time, and the rotation of each node from its rest: a pure function, so that
/// any moment can be computed alone. Segments keep their lengths; nodes that hold the surface stay in place.
/// A free end swings as a heavy chain by its two slowest modes (Bernoulli 1738); a part held at both ends
/// turns about the line between them; neither moves farther than its free space before the host. `position`
/// and `turn` are overwritten.
void swing_strands(const Strands& strands, const Breeze& breeze, double time, std::vector<Vec3>& position,
                   std::vector<Quat>& turn);

}  // namespace frond
