#pragma once

#include <string>

#include "core/files.h"
#include "emit/frame.h"
#include "scene_at.h"

namespace frond {

/// The text of a frame in a layout.
inline Result<std::string> frame_text(const Scene& scene, const FrameParts& parts, std::string_view layout,
                                      int frame) {
  std::string text;
  Result<FrameCount> written =
      write_frame(scene, parts, layout, frame, [&](std::string_view piece) { text += piece; });
  if (!written) return written.errors();
  return text;
}

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
