#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "model/surface.h"

namespace frond {

/// What the edges of a mesh say about it. Vertices at the same place count as one, so that a seam of a
/// texture is no edge of the body.
struct Solidity {
  std::size_t open = 0;  ///< edges that are not run exactly once each way
  long euler = 0;        ///< vertices - edges + faces; 2 for each body without a hole through it
};

inline Solidity solidity(const Surface& s) {
  std::map<std::array<float, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> weld;
  for (const Vec3& p : s.position)
    weld.push_back(
        places.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(places.size())).first->second);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs;
  for (auto [a, b, c] : s.triangle)
    ++runs[{weld[a], weld[b]}], ++runs[{weld[b], weld[c]}], ++runs[{weld[c], weld[a]}];
  Solidity result;
  for (auto [edge, count] : runs) {
    auto back = runs.find({edge.second, edge.first});
    if (count != 1 || back == runs.end() || back->second != 1) ++result.open;
  }
  result.euler = static_cast<long>(places.size()) - static_cast<long>(runs.size() / 2) +
                 static_cast<long>(s.triangle.size());
  return result;
}

}  // namespace frond
