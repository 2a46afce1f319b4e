#pragma once

#include <string>
#include <utility>
#include <vector>

#include "passes/traced_film.h"

namespace frond {

/// What compositors and those who need ground truth want to know of each pixel of a frame. Values at a pixel
/// are those of the ray through its middle; shares are of side * side rays through it and the camera's lens.
/// Row by row from the top.
struct FramePasses {
  int width = 0, height = 0;
  std::vector<float> depth;            ///< metres along the camera's axis; infinite where there is nothing
  std::vector<Vec3> position, normal;  ///< in the world, metres; of length 1; 0 where there is nothing
  std::vector<Vec2> forward,
      backward;                 ///< pixels, right and down, to where the spot is in the next frame and
                                ///< was in the one before; 0 at the film's ends and where it is not
  std::vector<float> coverage;  ///< share of rays that meet something
  std::vector<float> sun;       ///< share of rays that meet what the main light shines on
  /// Linear colours of surfaces without light; 0 where there is nothing. Empty: unknown here, see
  /// cli/albedo.h.
  std::vector<Vec3> albedo;
  std::vector<std::vector<std::pair<Thing, float>>> things;  ///< what rays meet, each with its share
};

/// The passes of frame `number` of a film, the first being 1; `side` * `side` rays are traced a pixel.
Result<FramePasses> frame_passes(const Scene& scene, const TracedFilm& film, int number, int side = 4);

/// What a thing is called: that of its preset's entry, of its organism, and of its part. "reef/3/organ 12"
struct ThingNames {
  std::string entry, organism, part;
};
ThingNames names_of(const Scene& scene, const Thing& thing);

}  // namespace frond
