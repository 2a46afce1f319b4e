#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "core/text.h"
#include "emit/frame_parts.h"

namespace frond {

/// The whole .pov text of frame `frame` (1 is the first): the layout with its holes filled. A pure function
/// of its arguments; `layout` is templates/frame.pov. An unknown hole is an error.
Result<std::string> frame_text(const Scene& scene, const FrameParts& parts, std::string_view layout,
                               int frame);

/// The name of the file with the soft light of one frame.
std::string light_name(int frame);

/// What a frame shows.
struct FrameCount {
  std::size_t nodes = 0;    ///< that growth has reached; those of copies do not count
  std::size_t objects = 0;  ///< of POV-Ray's, that stand in the hole `organisms`

  FrameCount& operator+=(const FrameCount& more) {
    nodes += more.nodes;
    objects += more.objects;
    return *this;
  }
};

/// Writes the text of frame_text() piece by piece: the text of a large frame is held nowhere as a whole.
/// `exposure`: of a frame that is made of several, which one, the first being 1; 0: the frame at its own
/// time, whatever the shutter.
Result<FrameCount> write_frame(const Scene& scene, const FrameParts& parts, std::string_view layout,
                               int frame, const Out& out, int exposure = 0);

}  // namespace frond
