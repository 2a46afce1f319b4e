#pragma once

#include <vector>

#include "scene/scene.h"

namespace frond {

/// What the open shutter sees of a drop that falls past. Metres.
struct Streak {
  Vec3 top{0}, bottom{0};
  float width = 0.001f;  ///< at least half a pixel
  float share = 0.05f;   ///< of the light there that is its own: of the time that a drop covers a place
};

/// Seconds for which the shutter is open at a time: that of one exposure, or 1/60 where the camera has none.
double open_time(const Film& film, const Camera& camera);

/// The drops near the camera that show: thicker than a third of a pixel, thicker ones first where there are
/// too many. Each falls again and again through a column of the air about the camera, slanted by the wind; a
/// pure function of the time, which repeats with the film. All others are the grey of the air.
std::vector<Streak> rain_streaks(const Scene& scene, double time);

/// Rings on water at once: squares of `cell` metres, in each of several layers one ring that lives for
/// `life` seconds, on a `share` of them. A whole number of lives makes the film.
struct RingField {
  int layers = 0;
  double cell = 0.6, life = 0.8, share = 1;
};

/// Those of drops thicker than 1.5 mm at a rate of rain, mm/h; at most 8 a square metre, as more would be too
/// many to be told apart.
RingField ring_field(double rate, const Film& film);

}  // namespace frond
