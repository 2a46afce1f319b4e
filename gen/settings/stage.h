#pragma once

#include <any>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/curve.h"
#include "core/vec.h"

namespace frond {

enum class Quality { draft, good, best };

struct Film {
  int frames = 72;  ///< 1: a still
  double fps = 24;
  std::array<int, 2> size{480, 270};  ///< width and height, pixels
  Quality quality = Quality::draft;

  double length() const { return frames / fps; }                            ///< seconds
  double time(int frame) const { return (frame - 1) / fps; }                ///< of a frame, the first being 1
  double aspect() const { return static_cast<double>(size[1]) / size[0]; }  ///< height by width
};

inline constexpr std::string_view kFitAll = "all";  ///< in place of names: every organism

/// What is sharp: a point, or the organism of a name where the camera sees it.
struct Focus {
  Animated<Vec3> point{Vec3(0)};
  std::string organism;  ///< empty: the point counts
};

struct Camera {
  Animated<Vec3> location{Vec3(0, 1.0f, 5)};
  Animated<Vec3> look_at{Vec3(0, 0.5f, 0)};
  Animated<double> angle{45.0};  ///< degrees, the width of the view
  bool follow = false;           ///< heights count from the ground below, not from y = 0
  std::vector<std::string> fit;  ///< names of organisms that it is moved to have in the picture, whole
  double margin = 0.06;          ///< of the picture's sides, that stay free at each edge of it
  double exposure = 0;           ///< stops more light than a meter says
  double highlights = 0;         ///< stops above white that are kept, see Tone
  double contrast = 1;           ///< of the picture, see Tone
  /// The f-number of a lens before film 36 mm wide; none: all is sharp.
  std::optional<double> aperture;
  std::optional<Focus> focus;  ///< what is sharp; else what it looks at
  double shutter = 0;          ///< share of a frame's time for which it is open, from the frame's moment on
  std::optional<int> shutter_samples;  ///< exposures that make a frame; else by quality

  /// Stops more light than a meter says, as POV-Ray draws it.
  double stops() const { return exposure - highlights; }
  /// Whether what POV-Ray draws still has to be developed.
  bool toned() const { return highlights != 0 || contrast != 1; }
};

/// So many exposures make a frame of a film; 1: no motion is blurred, nor is it in a still.
inline int exposures(const Film& film, const Camera& camera) {
  constexpr int kExposures[] = {1, 4, 8};
  if (camera.shutter <= 0 || film.frames == 1) return 1;
  return camera.shutter_samples.value_or(kExposures[static_cast<std::size_t>(film.quality)]);
}

/// Seconds at which an exposure of a frame is taken, the first being 1: in the middle of its share of the
/// time for which the shutter is open. Where there is but one it is the frame's own time.
inline double exposure_time(const Film& film, const Camera& camera, int frame, int exposure) {
  int count = exposures(film, camera);
  if (count == 1) return film.time(frame);
  return film.time(frame) + camera.shutter / film.fps * (exposure - 0.5) / count;
}

/// Low dunes or a lawn, and the loose stones on it.
struct Floor {
  double relief = 0.14, scale = 3.2;  ///< metres, see Dunes
  int stones = 50;                    ///< loose stones
  double stone_size = 0.22;           ///< metres, of the largest of them
  double extent = 7;                  ///< metres round the origin in which they lie
};

/// Everything but the organisms. Each setting has a block of parameters that only it knows, and that those
/// which build on it read.
struct Stage {
  Stage();  ///< all blocks as they are where a preset does not say

  std::size_t setting = 0;  ///< row of settings()
  Camera camera;
  Floor floor;
  std::vector<std::any> blocks;  ///< one a setting

  /// The block of a type, which one of the settings has.
  template <class Block>
  const Block& block() const {
    for (const std::any& held : blocks)
      if (const auto* found = std::any_cast<Block>(&held)) return *found;
    throw std::bad_any_cast();
  }
};

}  // namespace frond
