#include "creeping/mask.h"

#include <algorithm>
#include <cmath>

namespace frond {

bool CrawlMask::scaling(std::string_view what) const {
  return std::ranges::find(scales, what) != scales.end();
}

double CrawlMask::at(const TriangleSurface& host, std::uint32_t triangle, const DVec3& point) const {
  if (picture.along) return picture.at(point, host.low(), host.high());
  Vec3 paint = host.paint(triangle, point);
  if (picture.file.empty())
    return std::isnan(paint.z) ? 1.0 : std::clamp(static_cast<double>(paint.z), 0.0, 1.0);
  if (std::isnan(paint.x) || std::isnan(paint.y)) return 1;
  // Textures repeat beyond 0..1.
  auto within = [](double x) { return x < 0 || x > 1 ? x - std::floor(x) : x; };
  return picture.at_share(within(paint.x), 1 - within(paint.y));
}

}  // namespace frond
