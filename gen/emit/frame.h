#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/text.h"
#include "emit/copies.h"
#include "emit/polyps.h"
#include "emit/pov.h"
#include "emit/solid.h"
#include "scene/scene.h"

namespace frond {

inline constexpr std::string_view kOwnLight = "*";

/// What is the same in each frame of a film, written once.
struct FrameParts {
  std::vector<Picture> files;  ///< that frames include, to be put beside them
  CopyPlan plan;               ///< of the copies of stands
  PovSpace space;
  std::string materials;                ///< the skins of all organisms and the shapes of their organs
  std::string ground;                   ///< floor, stones, grass and solids
  DrawnSolids solids;                   ///< of all organisms
  std::vector<PolypPlaces> polyps;      ///< on the solids of each organism
  std::vector<std::string> copies;      ///< those that stand still, in each stretch of the film
  std::vector<std::size_t> first_skin;  ///< of each organism, in the array of skins
  std::string light;  ///< file of the soft light of all frames; kOwnLight: each has one; empty: none
};

/// With the plan of copies, whose files must have been counted.
FrameParts prepare_frames(const Scene& scene, CopyPlan plan = {});

/// The whole .pov text of frame `frame` (1 is the first): the layout with its holes filled. A pure function
/// of its arguments; `layout` is templates/frame.pov. An unknown hole is an error.
Result<std::string> frame_text(const Scene& scene, const FrameParts& parts, std::string_view layout,
                               int frame);

/// The file of the soft light that is a frame's own.
std::string light_name(int frame);

/// The same, piece by piece: the text of a large frame is held nowhere as a whole. Gives how many nodes
/// growth has reached in it; those of copies do not count. `exposure`: of a frame that is made of several,
/// which one, the first being 1; 0: the frame at its own time, whatever the shutter.
Result<std::size_t> write_frame(const Scene& scene, const FrameParts& parts, std::string_view layout,
                                int frame, const Out& out, int exposure = 0);

}  // namespace frond
