#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/assets.h"
#include "creeping/host.h"

namespace frond {

/// A grey, 0 to 1, that is painted on a host and scales what creeps there: 1 as everywhere, 0 nothing.
struct CrawlMask {
  FileName file;  ///< of a picture, laid on by texture coordinates; empty: the grey of the host's vertices
  int width = 0;  ///< pixels
  int height = 0;
  std::vector<std::uint8_t> grey;             ///< of the pixels, rows from the top down
  std::vector<std::string> scales{"leaves"};  ///< of kMaskScales
  double stops = 0;                           ///< strands neither begin nor go where it is below this

  bool scaling(std::string_view what) const;
  /// Its value at a point of a triangle; 1 where the host has no such paint.
  double at(const Host& host, std::uint32_t triangle, const DVec3& point) const;
};

inline constexpr std::string_view kMaskScales[] = {"bias", "spacing", "leaves"};

}  // namespace frond
