#include "creeping/soup.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace frond {

namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr double kSame = 1e-7;  // of the extent: vertices nearer than this are one

DVec3 area_of(const std::array<Vec3, 3>& c) {
  return glm::cross(DVec3(c[1]) - DVec3(c[0]), DVec3(c[2]) - DVec3(c[0]));
}

bool finite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// For each vertex of a surface the number of its place; equal places, equal numbers.
std::vector<std::uint32_t> places(const Surface& surface, std::size_t& count) {
  std::size_t n = surface.position.size();
  double extent = 0;
  for (const Vec3& p : surface.position)
    if (finite(p)) extent = std::max<double>({extent, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  double cell = std::max(extent * kSame, 1e-30);
  using Key = std::array<long long, 3>;
  std::vector<std::pair<Key, std::uint32_t>> keys(n);
  for (std::size_t i = 0; i < n; ++i) {
    Vec3 p = finite(surface.position[i]) ? surface.position[i] : Vec3(0);
    keys[i] = {{std::llround(p.x / cell), std::llround(p.y / cell), std::llround(p.z / cell)},
               static_cast<std::uint32_t>(i)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> place(n);
  count = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (k > 0 && keys[k].first != keys[k - 1].first) ++count;
    place[keys[k].second] = static_cast<std::uint32_t>(count);
  }
  if (n > 0) ++count;
  return place;
}

/// Takes over the triangles that have an area, each once.
void keep_triangles(const Surface& surface, const std::vector<std::uint32_t>& place, Soup& soup) {
  using Triple = std::array<std::uint32_t, 3>;
  std::vector<std::pair<Triple, std::uint32_t>> kept;
  std::size_t n = surface.position.size();
  for (std::size_t t = 0; t < surface.triangle.size(); ++t) {
    auto [a, b, c] = surface.triangle[t];
    if (a >= n || b >= n || c >= n) continue;
    if (!finite(surface.position[a]) || !finite(surface.position[b]) || !finite(surface.position[c]))
      continue;
    Triple v{place[a], place[b], place[c]};
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
    std::array<Vec3, 3> corners{surface.position[a], surface.position[b], surface.position[c]};
    double longest = 0;
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, glm::distance(DVec3(corners[i]), DVec3(corners[(i + 1) % 3])));
    if (!(glm::length(area_of(corners)) > 1e-9 * longest * longest)) continue;
    std::sort(v.begin(), v.end());
    kept.push_back({v, static_cast<std::uint32_t>(t)});
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end(), [](auto& a, auto& b) { return a.first == b.first; }),
             kept.end());
  std::sort(kept.begin(), kept.end(), [](auto& a, auto& b) { return a.second < b.second; });
  for (auto& [v, t] : kept) {
    auto [a, b, c] = surface.triangle[t];
    soup.vertex.push_back({place[a], place[b], place[c]});
    soup.corners.push_back({surface.position[a], surface.position[b], surface.position[c]});
    if (!surface.paint.empty()) soup.paint.push_back(surface.paint[t]);
  }
}

/// Finds who lies across each edge that just two triangles share.
void meet_neighbours(Soup& soup) {
  struct Edge {
    std::uint32_t low, high, triangle, side;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * soup.vertex.size());
  for (std::uint32_t t = 0; t < soup.vertex.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i) {
      std::uint32_t a = soup.vertex[t][i], b = soup.vertex[t][(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), t, i});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.triangle, a.side) < std::tie(b.low, b.high, b.triangle, b.side);
  });
  soup.neighbour.assign(soup.vertex.size(), {kNone, kNone, kNone});
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end - i == 2) {
      soup.neighbour[edges[i].triangle][edges[i].side] = edges[i + 1].triangle;
      soup.neighbour[edges[i + 1].triangle][edges[i + 1].side] = edges[i].triangle;
    }
    i = end;
  }
}

/// Whether two neighbours run their common edge in opposite directions, as they should.
bool agree(const Soup& soup, std::uint32_t t, std::uint32_t side, std::uint32_t other) {
  std::uint32_t a = soup.vertex[t][side], b = soup.vertex[t][(side + 1) % 3];
  for (int i = 0; i < 3; ++i)
    if (soup.vertex[other][i] == b && soup.vertex[other][(i + 1) % 3] == a) return true;
  return false;
}

/// Turns one piece, the triangles that hang together with `first`, into one orientation: outward where it is
/// closed, else as most of its area had it.
void turn_piece(Soup& soup, std::uint32_t first, std::vector<std::uint8_t>& seen,
                std::vector<std::uint32_t>& piece) {
  piece.assign(1, first);
  seen[first] = 1;
  bool closed = true;
  double kept = 0, turned = 0, volume = 0;
  DVec3 middle(soup.corners[first][0]);
  for (std::size_t k = 0; k < piece.size(); ++k) {
    std::uint32_t t = piece[k];
    soup.piece[t] = static_cast<std::uint32_t>(soup.pieces);
    (seen[t] == 1 ? kept : turned) += glm::length(area_of(soup.corners[t]));
    const auto& c = soup.corners[t];
    volume += glm::dot(DVec3(c[0]) - middle, glm::cross(DVec3(c[1]) - middle, DVec3(c[2]) - middle));
    for (std::uint32_t side = 0; side < 3; ++side) {
      std::uint32_t other = soup.neighbour[t][side];
      if (other == kNone) {
        closed = false;
      } else if (!seen[other]) {
        bool well = agree(soup, t, side, other);
        if (!well) flip(soup, other);
        seen[other] = well ? 1 : 2;
        piece.push_back(other);
      }
    }
  }
  if (closed ? volume < 0 : turned > kept)
    for (std::uint32_t t : piece) flip(soup, t);
  if (closed && volume != 0)
    for (std::uint32_t t : piece) soup.solid[t] = 1;
  ++soup.pieces;
}

}  // namespace

void flip(Soup& soup, std::uint32_t t) {
  std::swap(soup.vertex[t][1], soup.vertex[t][2]);
  std::swap(soup.corners[t][1], soup.corners[t][2]);
  std::swap(soup.neighbour[t][0], soup.neighbour[t][2]);
  if (!soup.paint.empty()) std::swap(soup.paint[t][1], soup.paint[t][2]);
}

Soup mend_surface(const Surface& surface) {
  Soup soup;
  std::vector<std::uint32_t> place = places(surface, soup.vertices);
  keep_triangles(surface, place, soup);
  meet_neighbours(soup);
  soup.solid.assign(soup.vertex.size(), 0);
  soup.piece.assign(soup.vertex.size(), 0);
  std::vector<std::uint8_t> seen(soup.vertex.size(), 0);
  std::vector<std::uint32_t> piece;
  for (std::uint32_t t = 0; t < soup.vertex.size(); ++t)
    if (!seen[t]) turn_piece(soup, t, seen, piece);
  return soup;
}

}  // namespace frond
