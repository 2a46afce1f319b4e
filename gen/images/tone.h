#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/result.h"

namespace frond {

/// How light becomes a picture, as on film: a curve over each channel.
struct Tone {
  double highlights =
      0;                ///< stops above white that keep their shape; the picture was exposed that much darker
  double contrast = 1;  ///< how steep the curve is at middle grey
};

/// The channel of a picture for a light as it was exposed, both linear, 0 to 1. Dark and middle light is as
/// it was before `highlights`; what is brighter bends over so that the brightest there can be is just white.
double toned(double light, const Tone& tone);

/// PNG files of 16 bits a channel, as POV-Ray writes them, as one of 8 bits with this tone. Of several, all
/// of one size, it is the mean of their light, as of exposures on one film.
Result<std::string> develop(std::span<const std::string> pngs, const Tone& tone);

}  // namespace frond
