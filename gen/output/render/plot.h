#pragma once

#include <optional>
#include <span>
#include <string>

namespace frond {

/// What a frame of a film holds and took, as far as it is known.
struct PlotFrame {
  int number = 1;
  std::optional<double> nodes, bytes, seconds;  ///< that have grown; of the scene; of processor
};

/// An SVG of these over the frames, which are at least one.
std::string plot_text(std::span<const PlotFrame> frames);

}  // namespace frond
