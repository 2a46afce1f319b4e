#pragma once

#include <string>
#include <vector>

#include "core/mask.h"
#include "creeping/triangle_surface.h"

namespace frond {

/// A grey, 0 to 1, that is painted on a host and scales what creeps there: 1 as everywhere, 0 nothing.
struct CrawlMask {
  /// Projected along its axis; without one, laid on by texture coordinates. No file: the grey of the host's
  /// vertices.
  Mask picture;
  std::vector<std::string> scales{"leaves"};  ///< of kMaskScales
  double stops = 0;                           ///< strands neither begin nor go where it is below this

  bool scaling(std::string_view what) const;
  /// Its value at a point of a triangle; 1 where the host has no such paint.
  double at(const TriangleSurface& host, std::uint32_t triangle, const DVec3& point) const;
};

inline constexpr std::string_view kMaskScales[] = {"bias", "spacing", "leaves"};

}  // namespace frond
