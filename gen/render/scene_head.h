#pragma once

#include <string>
#include <string_view>

#include "images/tone.h"

namespace frond {

/// What the first line of a scene says of how it is to be rendered.
struct SceneHead {
  std::string light;  ///< the file of soft light beside it; empty: none
  bool fine = false;  ///< POV-Ray draws 16 bits a channel, and the tone is given afterwards
  bool raw = false;   ///< those 16 bits are the picture, which frames are resolved from
  int exposures = 1;  ///< whose mean light is the picture
  Tone tone;
};

/// Reads it from the text of the scene, or from the beginning of it.
SceneHead read_scene_head(std::string_view scene);

}  // namespace frond
