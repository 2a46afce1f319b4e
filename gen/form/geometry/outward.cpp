#include "geometry/outward.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "core/bounds.h"
#include "core/joined_sets.h"

namespace frond {

namespace {

using TriangleSpan = std::span<const std::array<std::uint32_t, 3>>;

/// A piece of a mesh that hangs together.
struct MeshPiece {
  std::vector<std::uint32_t> triangles;
  double volume = 0;
  Bounds box;
  bool closed = false, turned = false;
};

/// For each vertex the first at the same place.
std::vector<std::uint32_t> welded(std::span<const Vec3> position) {
  std::vector<std::uint32_t> order(position.size()), first(position.size());
  std::iota(order.begin(), order.end(), 0u);
  auto key = [&](std::uint32_t i) { return std::tuple(position[i].x, position[i].y, position[i].z, i); };
  std::ranges::sort(order, [&](auto a, auto b) { return key(a) < key(b); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    bool same = k > 0 && position[order[k]] == position[order[k - 1]];
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  return first;
}

/// Whether each edge is run as often one way as the other.
bool is_closed(const MeshPiece& piece, TriangleSpan triangles, const std::vector<std::uint32_t>& vertex) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, int>> edges;
  for (std::uint32_t t : piece.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t a = vertex[triangles[t][k]], b = vertex[triangles[t][(k + 1) % 3]];
      edges.emplace_back(std::min(a, b), std::max(a, b), a < b ? 1 : -1);
    }
  std::ranges::sort(edges);
  for (std::size_t i = 0; i < edges.size();) {
    int sum = 0;
    auto [low, high, way] = edges[i];
    for (; i < edges.size() && std::get<0>(edges[i]) == low && std::get<1>(edges[i]) == high; ++i)
      sum += std::get<2>(edges[i]);
    if (sum != 0) return false;
  }
  return true;
}

/// The pieces that some of the triangles make up where vertices are those of a list.
std::vector<MeshPiece> pieces_of(std::span<const Vec3> position, TriangleSpan triangles,
                                 const std::vector<std::uint32_t>& which,
                                 const std::vector<std::uint32_t>& vertex) {
  JoinedSets joined(position.size());
  for (std::uint32_t t : which)
    for (std::size_t k = 1; k < 3; ++k) joined.join(vertex[triangles[t][0]], vertex[triangles[t][k]]);
  std::map<std::uint32_t, std::size_t> known;
  std::vector<MeshPiece> pieces;
  for (std::uint32_t t : which) {
    auto [place, fresh] = known.try_emplace(joined.top(vertex[triangles[t][0]]), pieces.size());
    if (fresh) pieces.emplace_back();
    pieces[place->second].triangles.push_back(t);
  }
  for (MeshPiece& piece : pieces) {
    DVec3 middle(position[triangles[piece.triangles[0]][0]]);
    for (std::uint32_t t : piece.triangles) {
      auto at = [&](std::size_t k) { return DVec3(position[triangles[t][k]]) - middle; };
      piece.volume += glm::dot(at(0), glm::cross(at(1), at(2)));
      for (std::uint32_t v : triangles[t]) piece.box.extend(position[v]);
    }
    piece.closed = is_closed(piece, triangles, vertex);
  }
  return pieces;
}

bool holds(const Bounds& outer, const Bounds& inner) {
  return glm::all(glm::lessThan(outer.low, inner.low)) && glm::all(glm::greaterThan(outer.high, inner.high));
}

}  // namespace

std::vector<char> inward(std::span<const Vec3> position, TriangleSpan triangles) {
  std::vector<std::uint32_t> vertex(position.size()), left(triangles.size());
  std::iota(vertex.begin(), vertex.end(), 0u);
  std::iota(left.begin(), left.end(), 0u);
  std::vector<MeshPiece> closed;
  for (bool weld : {false, true}) {
    if (left.empty()) break;
    if (weld) vertex = welded(position);
    std::vector<std::uint32_t> open;
    for (MeshPiece& piece : pieces_of(position, triangles, left, vertex))
      if (piece.closed)
        closed.push_back(std::move(piece));
      else
        open.insert(open.end(), piece.triangles.begin(), piece.triangles.end());
    left = std::move(open);
  }
  std::ranges::stable_sort(
      closed, [](const MeshPiece& a, const MeshPiece& b) { return std::abs(a.volume) > std::abs(b.volume); });
  constexpr std::size_t kMostOuter = 64;  // the largest, which others may lie in
  std::vector<char> turned(triangles.size(), 0);
  for (std::size_t i = 0; i < closed.size(); ++i) {
    auto outer =
        std::find_if(closed.begin(), closed.begin() + static_cast<std::ptrdiff_t>(std::min(i, kMostOuter)),
                     [&](const MeshPiece& other) { return holds(other.box, closed[i].box); });
    bool inner = outer != closed.begin() + static_cast<std::ptrdiff_t>(std::min(i, kMostOuter));
    closed[i].turned = inner ? outer->turned : closed[i].volume < 0;
    if (closed[i].turned)
      for (std::uint32_t t : closed[i].triangles) turned[t] = 1;
  }
  return turned;
}

}  // namespace frond
