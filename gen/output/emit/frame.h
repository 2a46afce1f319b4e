#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/text.h"
#include "draw/levels.h"
#include "draw/twig_plan.h"
#include "emit/solid.h"
#include "scene/scene.h"

namespace frond {

inline constexpr std::string_view kOwnLight = "*";

/// What is the same in each frame of a film, written once.
struct FrameParts {
  std::vector<Picture> files;  ///< that frames include, to be put beside them
  CopyPlan plan;               ///< of the copies that are sown
  PovSpace space;
  std::string materials;            ///< the skins of all organisms and the shapes of their organs
  std::string ground;               ///< floor, stones, grass and solids
  DrawnSolids solids;               ///< of all organisms
  std::vector<PolypPlaces> polyps;  ///< on the solids of each organism
  std::vector<SeptumPlaces> septa;  ///< the same
  std::vector<std::string> copies;  ///< those that stand still, in each stretch of the film
  /// Metres that a pixel is at each organism where the camera comes nearest to it; 0: all its detail is
  /// written.
  std::vector<double> pixel;
  std::vector<std::size_t> first_skin;                 ///< of each organism, in the array of skins
  std::vector<std::shared_ptr<const TwigPlan>> twigs;  ///< of each organism; null: each by itself
  std::string light;  ///< file of the soft light of all frames; kOwnLight: each has one; empty: none
};

/// With the plan of copies, whose files must have been counted. `for_film`: all is as fine as the film shows,
/// and what is long goes into files that all its frames include.
FrameParts prepare_frames(const Scene& scene, CopyPlan plan = {}, bool for_film = true);

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

/// Writes the .pov text of frame `frame` (1 is the first): the layout with its holes filled, piece by piece,
/// as the text of a large frame is held nowhere as a whole. A pure function of its arguments; `layout` is
/// templates/frame.pov. An unknown hole is an error. `exposure`: of a frame that is made of several, which
/// one, the first being 1; 0: the frame at its own time, whatever the shutter.
Result<FrameCount> write_frame(const Scene& scene, const FrameParts& parts, std::string_view layout,
                               int frame, const Out& out, int exposure = 0);

}  // namespace frond
