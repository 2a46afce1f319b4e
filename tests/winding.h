#pragma once

#include <cmath>

#include "creeping/triangle_surface.h"

namespace frond {

/// The winding number of a host round a place: the share of all directions that its faces take there, backs
/// positive (Jacobson and others 2013). About 1 within a scan, whatever holes it has, and 0 outside of it.
inline double winding(const TriangleSurface& host, const DVec3& place) {
  double angle = 0;
  for (const auto& t : host.triangles()) {
    DVec3 a = DVec3(t[0]) - place, b = DVec3(t[1]) - place, c = DVec3(t[2]) - place;
    double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    double volume = glm::dot(a, glm::cross(b, c));
    angle += 2 * std::atan2(volume,
                            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return angle / (4 * kPi);
}

}  // namespace frond
