#include "geometry/smooth.h"

#include <cassert>

#include "core/curve.h"
#include "core/spline.h"

namespace frond {

namespace {

/// The node that goes on from `i` in the same chain, or kRoot where the chain ends.
std::int32_t next_in_chain(const Skeleton& s, std::size_t i) {
  bool goes_on = i + 1 < s.size() && s.parent[i + 1] == static_cast<std::int32_t>(i);
  return goes_on ? static_cast<std::int32_t>(i) + 1 : Skeleton::kRoot;
}

/// Whether the segment below `i` continues the one below its parent, rather than leaving it at a fork.
bool continues(const Skeleton& s, std::int32_t i) {
  std::int32_t p = s.parent[i];
  return p != Skeleton::kRoot && p == i - 1 && s.parent[p] != Skeleton::kRoot;
}

}  // namespace

Skeleton smooth(const Skeleton& coarse, int pieces) {
  assert(pieces >= 1);
  Skeleton fine;
  std::size_t n = coarse.size();
  fine.reserve(n * static_cast<std::size_t>(pieces));
  std::vector<std::int32_t> index(n);  // of each coarse node among the fine ones
  for (std::size_t i = 0; i < n; ++i) {
    std::int32_t p = coarse.parent[i];
    if (p == Skeleton::kRoot) {
      index[i] = fine.add(coarse.position[i], coarse.radius[i], p, coarse.order[i]);
      fine.birth.back() = coarse.birth[i];
      continue;
    }
    Vec3 from = coarse.position[p], to = coarse.position[i];
    std::int32_t next = next_in_chain(coarse, i);
    Vec3 leave = continues(coarse, static_cast<std::int32_t>(i))
                     ? spline_slopes(coarse.position[coarse.parent[p]], from, to).out
                     : to - from;
    Vec3 arrive = next == Skeleton::kRoot ? to - from : spline_slopes(from, to, coarse.position[next]).in;
    std::int32_t below = index[p];
    for (int k = 1; k <= pieces; ++k) {
      float t = static_cast<float>(k) / static_cast<float>(pieces);
      Hermite w = hermite(t);
      Vec3 at = from * static_cast<float>(w.start) + leave * static_cast<float>(w.start_slope) +
                to * static_cast<float>(w.end) + arrive * static_cast<float>(w.end_slope);
      if (k == pieces) at = to;
      below = fine.add(at, glm::mix(coarse.radius[p], coarse.radius[i], t), below, coarse.order[i]);
      fine.birth.back() = glm::mix(coarse.birth[p], coarse.birth[i], t);
    }
    index[i] = below;
  }
  return fine;
}

std::vector<std::int32_t> smoothed_index(const Skeleton& coarse, int pieces) {
  std::vector<std::int32_t> index(coarse.size());
  std::int32_t count = 0;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    count += coarse.parent[i] == Skeleton::kRoot ? 1 : pieces;
    index[i] = count - 1;
  }
  return index;
}

}  // namespace frond
