#pragma once

#include <string>

#include "core/files.h"
#include "emit/frame.h"
#include "scene_at.h"

namespace frond {

/// The text of a frame in the layout of all.
inline std::string text_of(const Scene& scene, int frame) {
  return *frame_text(scene, prepare_frames(scene), *read_file(FROND_ROOT "/templates/frame.pov"), frame);
}

inline std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + what.size())) ++n;
  return n;
}

}  // namespace frond
