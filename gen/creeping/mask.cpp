#include "creeping/mask.h"

#include <algorithm>
#include <cmath>

namespace frond {

bool CrawlMask::scaling(std::string_view what) const {
  return std::ranges::find(scales, what) != scales.end();
}

double CrawlMask::at(const Host& host, std::uint32_t triangle, const DVec3& point) const {
  Vec3 paint = host.paint(triangle, point);
  if (file.empty()) return std::isnan(paint.z) ? 1.0 : std::clamp(static_cast<double>(paint.z), 0.0, 1.0);
  if (std::isnan(paint.x) || std::isnan(paint.y) || grey.empty()) return 1;
  // Textures repeat beyond 0..1.
  auto within = [](double x) { return x < 0 || x > 1 ? x - std::floor(x) : x; };
  double x = std::clamp(within(paint.x) * width - 0.5, 0.0, width - 1.0);
  double y = std::clamp((1 - within(paint.y)) * height - 0.5, 0.0, height - 1.0);
  int left = static_cast<int>(x), top = static_cast<int>(y);
  int right = std::min(left + 1, width - 1), bottom = std::min(top + 1, height - 1);
  auto pixel = [&](int i, int k) {
    return static_cast<double>(
        grey[static_cast<std::size_t>(k) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)]);
  };
  double upper = std::lerp(pixel(left, top), pixel(right, top), x - left);
  double lower = std::lerp(pixel(left, bottom), pixel(right, bottom), x - left);
  return std::lerp(upper, lower, y - top) / 255;
}

}  // namespace frond
