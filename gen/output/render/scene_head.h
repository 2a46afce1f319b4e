#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "images/tone.h"

namespace frond {

/// What the first line of a scene says of how it is to be rendered.
struct SceneHead {
  std::string light;   ///< the file of soft light beside it; empty: none
  bool fine = false;   ///< POV-Ray draws 16 bits a channel, and the tone is given afterwards
  bool raw = false;    ///< those 16 bits are the picture, or what frames are resolved from
  bool alpha = false;  ///< with opacity
  int depth = 8;       ///< bits of a channel after the tone was given
  /// POV-Ray's flags for the part that it draws, and the part of that which is wanted: x, y, width, height;
  /// empty: the whole.
  std::vector<std::string> part;
  std::array<int, 4> crop{};
  int exposures = 1;  ///< whose mean light is the picture
  Tone tone;
};

/// Reads it from the text of the scene, or from the beginning of it.
SceneHead read_scene_head(std::string_view scene);
/// That of a file; nothing is said by one that cannot be read.
SceneHead scene_head_of(const std::filesystem::path& scene);

}  // namespace frond
