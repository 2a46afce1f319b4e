#pragma once

#include <vector>

#include "core/vec.h"

namespace frond {

/// Whether a closed outline encloses a point, by how often a ray along x crosses it.
inline bool encloses(const std::vector<Vec2>& outline, Vec2 at) {
  bool in = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    Vec2 a = outline[i], b = outline[j];
    bool crosses = (a.y > at.y) != (b.y > at.y);
    if (crosses && at.x < (b.x - a.x) * (at.y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  return in;
}

}  // namespace frond
