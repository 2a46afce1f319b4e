#include "core/mask.h"

#include <algorithm>

namespace frond {

double Mask::at_share(double across, double down) const {
  if (empty()) return 1;
  double x = std::clamp(across * width - 0.5, 0.0, width - 1.0);
  double y = std::clamp(down * height - 0.5, 0.0, height - 1.0);
  int left = static_cast<int>(x), top = static_cast<int>(y);
  int right = std::min(left + 1, width - 1), bottom = std::min(top + 1, height - 1);
  auto pixel = [&](int column, int row) { return static_cast<double>((*grey)[row * width + column]); };
  double s = x - left, t = y - top;
  return (1 - t) * ((1 - s) * pixel(left, top) + s * pixel(right, top)) +
         t * ((1 - s) * pixel(left, bottom) + s * pixel(right, bottom));
}

double Mask::at(const DVec3& place, const DVec3& low, const DVec3& high) const {
  if (empty()) return 1;
  Axis axis = along.value_or(Axis::y);
  auto across = [&](const DVec3& p) {
    return axis == Axis::y   ? glm::dvec2(p.x, p.z)
           : axis == Axis::z ? glm::dvec2(p.x, p.y)
                             : glm::dvec2(p.z, p.y);
  };
  glm::dvec2 from = across(low), to = across(high);
  if (area.size() == 2) from = glm::min(area[0], area[1]), to = glm::max(area[0], area[1]);
  glm::dvec2 share = (across(place) - from) / glm::max(to - from, 1e-9);
  return at_share(share.x, axis == Axis::y ? share.y : 1 - share.y);
}

double Mask::on_land(Vec2 at, double side) const {
  return this->at(DVec3(at.x, 0, at.y), DVec3(-side / 2), DVec3(side / 2));
}

}  // namespace frond
