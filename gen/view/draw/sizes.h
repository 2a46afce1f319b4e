#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace frond {

/// How large the individuals of an organism have become, the largest of them. Metres; of what is sown only
/// how tall and wide it may be is known.
struct GrownSize {
  std::string name;
  std::size_t count = 0;  ///< also of those of which nothing is to be seen yet
  double height = 0, width = 0;
  double stem = 0;  ///< thickness at 1.3 m, or at a tenth of the height where that is less; 0: it has none
};

/// The sizes of the organisms of a scene at a time in seconds, in the order of its preset.
Result<std::vector<GrownSize>> sizes_of(const Scene& scene, const Preset& preset, double time);

/// `oak: 17.3 m high, 15.2 m wide, stem of 71 cm` for each of which there are some.
std::vector<std::string> sizes_lines(const std::vector<GrownSize>& sizes);

}  // namespace frond
