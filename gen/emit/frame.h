#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// What is the same in each frame of a film, written once.
struct FrameParts {
  PovSpace space;
  std::string materials;                ///< the skins of all organisms and the shapes of their organs
  std::string ground;                   ///< floor, stones, grass and solids
  std::vector<std::size_t> first_skin;  ///< of each organism, in the array of skins
};

FrameParts prepare_frames(const Scene& scene);

/// The whole .pov text of frame `frame` (1 is the first): the layout with its holes filled. A pure function
/// of its arguments; `layout` is templates/frame.pov. An unknown hole is an error.
Result<std::string> frame_text(const Scene& scene, const FrameParts& parts, std::string_view layout,
                               int frame);

}  // namespace frond
