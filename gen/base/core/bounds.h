#pragma once

#include <algorithm>
#include <span>

#include "core/vec.h"

namespace frond {

/// An axis-aligned bounding box; empty at first.
struct Bounds {
  Vec3 low{1e30f}, high{-1e30f};

  void extend(Vec3 at, float round = 0) {
    low = glm::min(low, at - round);
    high = glm::max(high, at + round);
  }
  void extend(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  bool empty() const { return low.x > high.x; }
  Vec3 size() const { return high - low; }
  Vec3 middle() const { return (low + high) * 0.5f; }
  /// The middle of its bottom face.
  Vec3 foot() const { return Vec3((low.x + high.x) * 0.5f, low.y, (low.z + high.z) * 0.5f); }
  /// Corner k of its eight corners.
  Vec3 corner(int k) const {
    return {(k & 1) ? high.x : low.x, (k & 2) ? high.y : low.y, (k & 4) ? high.z : low.z};
  }
  float longest() const { return std::max({size().x, size().y, size().z}); }
};

/// How far the farthest of some places is from the origin, metres; 0 of none.
inline float reach_of(std::span<const Vec3> places) {
  float most = 0;
  for (const Vec3& p : places) most = std::max(most, glm::length(p));
  return most;
}

inline Bounds bounds_of(std::span<const Vec3> places) {
  Bounds box;
  for (const Vec3& at : places) box.extend(at);
  return box;
}

}  // namespace frond
