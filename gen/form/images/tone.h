#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "core/result.h"

namespace frond {

/// Pixels of pictures that are held whole; larger ones are made in bands.
inline constexpr std::size_t kHeldPixels = 40'000'000;

/// Tone mapping as on film: a curve over each channel, and what becomes of colours and corners.
struct Tone {
  double highlights =
      0;  ///< stops above white that keep their detail; the picture was exposed darker by as much
  double contrast = 1;    ///< slope of the curve at middle grey
  double saturation = 1;  ///< factor of how colourful it is; 0 grey
  double warmth = 0;  ///< share of red that white gains and of blue that it loses; black the other way round
  double vignette = 0;  ///< share of their light that the corners lose

  /// Whether a channel depends neither on the others nor on its place.
  bool is_curve() const { return saturation == 1 && warmth == 0 && vignette == 0; }
};

/// Output of a channel for its exposed light, both linear, 0 to 1. Dark and middle values are independent of
/// `highlights`; brighter ones are compressed so that the brightest possible light is just white.
double toned(double light, const Tone& tone);

/// What is seen, encoded, of the exposed light of a pixel of a picture of so many pixels, linear, red, green
/// and blue, each 0 to 1. Where no channel is full, saturation and warmth leave the luminance as it is.
std::array<double, 3> seen(const std::array<double, 3>& light, const Tone& tone, std::array<int, 2> pixel,
                           std::array<int, 2> size);

/// Converts a PNG file of 16 bits per channel, as POV-Ray writes it, to 8 bits, or 16, with this tone.
/// Several of equal size are averaged in linear light, as exposures of one frame; opacity is kept, and
/// colours are averaged by it. Pictures of more than `held` pixels are made a band at a time and must not be
/// interlaced.
Result<std::string> develop(std::span<const std::string> pngs, const Tone& tone, int depth = 8,
                            std::size_t held = kHeldPixels);

}  // namespace frond
