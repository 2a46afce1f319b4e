#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "core/result.h"

namespace frond {

/// Pixels of pictures that are held whole; larger ones are made in bands.
inline constexpr std::size_t kHeldPixels = 40'000'000;

/// Tone mapping as on film: a curve over each channel.
struct Tone {
  double highlights =
      0;  ///< stops above white that keep their detail; the picture was exposed darker by as much
  double contrast = 1;  ///< slope of the curve at middle grey
};

/// Output of a channel for its exposed light, both linear, 0 to 1. Dark and middle values are independent of
/// `highlights`; brighter ones are compressed so that the brightest possible light is just white.
double toned(double light, const Tone& tone);

/// Converts a PNG file of 16 bits per channel, as POV-Ray writes it, to 8 bits, or 16, with this tone.
/// Several of equal size are averaged in linear light, as exposures of one frame; opacity is kept, and
/// colours are averaged by it. Pictures of more than `held` pixels are made a band at a time and must not be
/// interlaced.
Result<std::string> develop(std::span<const std::string> pngs, const Tone& tone, int depth = 8,
                            std::size_t held = kHeldPixels);

}  // namespace frond
