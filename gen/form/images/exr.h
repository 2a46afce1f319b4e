#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"

namespace frond {

/// One channel of an OpenEXR picture: a number per pixel, row by row from the top.
struct ExrChannel {
  /// How a number is stored: 16 bits, which keep three digits up to 65504, 32 bits, or a whole number of 32
  /// bits.
  enum class Kind { half, single, whole };

  std::string name;  ///< as "R", "Z" or "normal.X"; 1 to 255 bytes
  Kind kind = Kind::half;
  std::vector<float> values;          ///< of a half or a single; what is too large for a half is the largest
  std::vector<std::uint32_t> wholes;  ///< of a whole
};

/// Name and value of what else an OpenEXR file says of itself, as text.
using ExrAttributes = std::vector<std::pair<std::string, std::string>>;

/// The bytes of an OpenEXR file of scan lines, compressed without loss (ZIP), of `size` pixels wide and high.
/// Each channel holds a number for every pixel. Equal pictures give equal bytes: nothing tells of the time or
/// of who made it. An error where two channels have one name, or a name is none.
Result<std::string> exr_bytes(std::array<int, 2> size, std::span<const ExrChannel> channels,
                              const ExrAttributes& attributes = {});

}  // namespace frond
