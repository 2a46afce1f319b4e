#pragma once

#include <fmt/format.h>

#include <string>

#include "scene_at.h"

namespace frond {

/// A film of two frames of an aspen with some 40,000 leaves in the wind, from so many metres away; `twigs` as
/// Film::twigs.
inline Scene aspen_scene(double away, double twigs) {
  std::string preset = fmt::format(R"({{"seed": 4, "film": {{"frames": 2, "size": [960, 720], "twigs": {}}},
    "scene": {{"setting": "studio", "wind": {{"speed": 6}},
               "camera": {{"location": [0, 4, {}], "look_at": [0, 6, 0], "angle": 40}}}},
    "organisms": [{{"kind": "weber_penn", "place": {{"at": [[0, 0]]}},
      "tree": {{"scale": 11, "levels": 3, "trunk": {{"curve_res": 20}},
        "branches": {{"branches": 110, "length": 0.3, "down_angle": 62, "curve_res": 6}},
        "twigs": {{"branches": 30, "length": 0.4, "down_angle": 50, "curve_res": 3}},
        "leaves": 22, "leaf_scale": 0.085}},
      "bark": {{}}, "leaves": {{"shape": "aspen", "size_variation": 0.3}}}}]}})",
                                   twigs, away);
  return *build_scene(taken(read_preset(preset, "aspen", {})));
}

}  // namespace frond
