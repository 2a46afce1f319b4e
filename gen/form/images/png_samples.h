#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace frond {

/// The samples of a PNG file as they are stored, 8 or 16 bits each (the high byte first), rows from the top
/// down.
struct PngSamples {
  int width = 0, height = 0;
  int channels = 3;   ///< 1 grey, 2 grey and opacity, 3 colour, 4 colour and opacity
  int bits = 8;       ///< of a sample
  int gamma = 45455;  ///< as the file's gAMA has it; 0: none
  std::vector<std::uint8_t> data;

  /// Bytes of a pixel and of a row.
  std::size_t pixel() const { return static_cast<std::size_t>(channels * bits / 8); }
  std::size_t row() const { return pixel() * static_cast<std::size_t>(width); }
  /// Sets sample number `i` of a picture of 16 bits to a share from 0 to 1.
  void set16(std::size_t i, double share);
};

/// Reads a PNG file without a table of colours, of 65536 pixels a side at most.
Result<PngSamples> read_samples(std::string_view png);
/// The bytes of a PNG file; equal samples give equal bytes.
Result<std::string> samples_text(const PngSamples& samples);

/// The rectangle of a picture whose upper left pixel is (x, y); it must lie within.
PngSamples cut(const PngSamples& whole, int x, int y, int width, int height);

/// A PNG file that says how many pixels an inch it has (pHYs).
std::string with_density(std::string_view png, double dpi);

}  // namespace frond
