#pragma once

#include <string>
#include <vector>

#include "images/raster.h"
#include "passes/frame_passes.h"

namespace frond {

/// Passes of a frame as a person looks at them.
struct PassView {
  std::string name;
  Raster picture;
};

/// depth: near is bright, and half as bright `middle` metres away; normal: x, y and z as red, green and blue;
/// sun: what it shines on; parts: a colour each; motion to the next frame: its direction as a hue, full from
/// 2 % of the picture's width on; albedo, where it is known.
std::vector<PassView> pass_views(const FramePasses& passes, float middle);

}  // namespace frond
