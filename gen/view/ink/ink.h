#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "images/raster.h"
#include "passes/traced_film.h"

// Ink drawings
// ============
// A frame as a botanist draws it: outlines and hatching, on white or on nothing. What rays meet is known
// exactly (passes/traced_film.h), so the drawing is a pure function of it and of no renderer's picture.
//
// Outlines are where surfaces end before others: a line is the wider the farther behind the other surface is,
// creases and leaves that lie on each other have thin ones. Where lines would lie too close, as in a crown,
// the strongest are kept, fewer in the light (after DeCarlo and Rusinkiewicz 2007, on abstraction).
//
// Hatching lines are level lines of a coordinate of the surface: round a branch the angle, so that they run
// along it; else a direction in the thing's own axes. Their distance is a power of two in that coordinate
// nearest to one in the picture, and every other line fades in and out between two powers (as in Praun et al.
// 2001), so they neither crowd nor swim. The light comes from the upper left of the viewer. Light parts are
// left white, dark ones get a second layer across the first.

namespace frond {

/// What a ray of a drawing meets.
struct InkSample {
  float depth = 0;  ///< metres along the camera's axis; 0: nothing is there
  Vec3 at{0}, normal{0};
  std::uint32_t thing = 0;           ///< a number of its own, of each thing
  float shade = 0;                   ///< 0 in full light .. 1
  std::array<float, 2> phase{};      ///< coordinates whose level lines are drawn
  std::array<float, 2> slope{1, 1};  ///< how much they change over a pixel of the picture
  float across = 0;  ///< a coordinate of the picture's diagonal, metres, for what is too fine for its own
};

/// fine * fine rays a pixel, row by row from the top.
struct InkSamples {
  int width = 0, height = 0;  ///< of the picture
  int fine = 2;
  float metres = 0.001f;  ///< of a pixel, one metre before the camera
  std::vector<InkSample> samples;
};

struct InkStyle {
  float pen = 1;       ///< pixels, width of a usual line
  float hatch = 4.5f;  ///< widths of a line between two lines of hatching; 0: none is hatched
  bool paper = true;   ///< white; else nothing, and the picture has opacity
};

InkSamples ink_samples(const TracedFrame& frame, int width, int height, int fine);

/// How much ink is at each pixel, 0..1.
Grid ink_drawing(const InkSamples& samples, const InkStyle& style = {});

/// A drawing in ink of a colour.
Raster ink_picture(const Grid& ink, bool paper);

}  // namespace frond
