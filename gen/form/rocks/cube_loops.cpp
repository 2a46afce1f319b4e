#include "rocks/cube_loops.h"

#include <cassert>
namespace frond {

namespace {

/// The corners of a face, counter-clockwise seen from outside; face = 2 * axis + (1 on the upper side).
std::array<unsigned, 4> face_corners(unsigned face) {
  unsigned axis = face / 2, u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3;
  if (face % 2 == 0) return {0, v, u | v, u};
  unsigned base = 1u << axis;
  return {base, base | u, base | u | v, base | v};
}

std::uint8_t edge_between(unsigned a, unsigned b) {
  assert(a < 8 && b < 8 && a != b);
  const auto& edges = CubeLoops::edges();
  for (std::uint8_t e = 0; e < CubeLoops::kEdges; ++e)
    if ((edges[e][0] == a && edges[e][1] == b) || (edges[e][0] == b && edges[e][1] == a)) return e;
  return 0;
}

/// Where the surface goes on from an edge, and through which face.
using Next = std::array<CubeLoops::Step, CubeLoops::kEdges>;

std::vector<CubeLoops::Loop> loops_of(unsigned inside) {
  Next next{};
  std::array<bool, CubeLoops::kEdges> open{};
  auto in = [&](unsigned corner) { return (inside >> corner & 1) != 0; };
  for (unsigned face = 0; face < 6; ++face) {
    auto corners = face_corners(face);
    for (unsigned i = 0; i < 4; ++i) {
      // Round the face, from where it leaves the inside back to where it last entered.
      if (!in(corners[i]) || in(corners[(i + 1) % 4])) continue;
      unsigned k = i;
      while (in(corners[(k + 3) % 4])) k = (k + 3) % 4;
      std::uint8_t leaves = edge_between(corners[i], corners[(i + 1) % 4]);
      std::uint8_t enters = edge_between(corners[(k + 3) % 4], corners[k]);
      next[enters] = {leaves, static_cast<std::uint8_t>(face)};
      open[enters] = true;
    }
  }
  std::vector<CubeLoops::Loop> loops;
  for (std::uint8_t start = 0; start < CubeLoops::kEdges; ++start) {
    CubeLoops::Loop loop;
    for (std::uint8_t e = start; open[e]; e = next[e].edge) {
      open[e] = false;
      loop.push_back({e, next[e].face});
    }
    if (!loop.empty()) loops.push_back(loop);
  }
  return loops;
}

}  // namespace

const std::array<std::array<std::uint8_t, 2>, CubeLoops::kEdges>& CubeLoops::edges() {
  static const auto all = [] {
    std::array<std::array<std::uint8_t, 2>, kEdges> list{};
    std::size_t count = 0;
    for (unsigned axis = 0; axis < 3; ++axis)
      for (unsigned corner = 0; corner < 8; ++corner)
        if ((corner >> axis & 1) == 0)
          list[count++] = {static_cast<std::uint8_t>(corner), static_cast<std::uint8_t>(corner | 1u << axis)};
    return list;
  }();
  return all;
}

const std::array<std::vector<CubeLoops::Loop>, 256>& CubeLoops::table() {
  static const auto all = [] {
    std::array<std::vector<Loop>, 256> list;
    for (unsigned inside = 0; inside < 256; ++inside) list[inside] = loops_of(inside);
    return list;
  }();
  return all;
}

}  // namespace frond
