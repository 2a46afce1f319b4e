#pragma once

#include <array>

#include "creeping/swing.h"

namespace frond {

/// How hanging strands move in gusts of wind, simulated once. For each moment and each hanging node there is
/// the rotation of its segment from rest, as the two components of the axis across it times the angle.
struct SwingPaths {
  double step = 0;                                ///< seconds from moment to moment
  int steps = 0;                                  ///< moments, after which all repeats; 1: a still
  std::vector<std::int32_t> node;                 ///< those that hang, parents before children
  std::vector<std::array<std::int16_t, 2>> tilt;  ///< [moment * nodes + index in `node`], of pi / 32767
};

/// Simulates strands whose Crawl has that stiffness (creeping/hung_chain.h) in wind of breeze.speed, > 0,
/// whose gusts travel with it. The motion repeats with the film, in a long film several times within it. The
/// simulation begins some seconds before the film, and its end is blended into its beginning. The paths are
/// the same with any number of threads.
SwingPaths swing_paths(const Strands& strands, const Breeze& breeze, double stiffness);

/// The strands in the wind at a time and the rotation of each node, as swing_strands() of creeping/swing.h
/// gives them, but by the simulated paths of these strands. `position` and `turn` are overwritten.
void swing_strands(const Strands& strands, const SwingPaths& paths, double time, std::vector<Vec3>& position,
                   std::vector<Quat>& turn);

}  // namespace frond
