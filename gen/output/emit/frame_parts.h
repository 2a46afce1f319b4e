#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "draw/levels.h"
#include "emit/polyps.h"
#include "emit/pov.h"
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
  std::vector<std::string> copies;  ///< those that stand still, in each stretch of the film
  /// Metres that a pixel is at each organism where the camera comes nearest to it; 0: all its detail is
  /// written.
  std::vector<double> pixel;
  std::vector<std::size_t> first_skin;  ///< of each organism, in the array of skins
  std::string light;  ///< file of the soft light of all frames; kOwnLight: each has one; empty: none
};

/// With the plan of copies, whose files must have been counted. `for_film`: all is as fine as the film shows,
/// and what is long goes into files that all its frames include.
FrameParts prepare_frames(const Scene& scene, CopyPlan plan = {}, bool for_film = true);

}  // namespace frond
