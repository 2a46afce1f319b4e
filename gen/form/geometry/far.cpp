#include "geometry/far.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>

#include "core/joined_sets.h"
#include "core/parallel.h"

namespace frond {

namespace {

/// What a piece of a surface adds up to.
struct Piece {
  Vec3 middle{0}, facing{0};  // middle times area; the sum of the triangles' area vectors
  Vec2 uv{0};                 // times area
  float area = 0;
  std::vector<std::uint32_t> vertices;
};

std::vector<Piece> measured(const Surface& s, const Pieces& pieces, bool whole) {
  std::vector<Piece> list(whole ? 1 : pieces.count);
  auto piece_of = [&](std::uint32_t vertex) -> Piece& { return list[whole ? 0 : pieces.of[vertex]]; };
  for (auto [a, b, c] : s.triangle) {
    Piece& piece = piece_of(a);
    Vec3 across = area_of(s, {a, b, c}) * 0.5f;
    float area = glm::length(across);
    piece.area += area;
    piece.facing += across;
    piece.middle += (s.position[a] + s.position[b] + s.position[c]) * (area / 3);
    if (!s.uv.empty()) piece.uv += (s.uv[a] + s.uv[b] + s.uv[c]) * (area / 3);
  }
  for (std::uint32_t v = 0; v < s.position.size(); ++v) piece_of(v).vertices.push_back(v);
  return list;
}

std::uint32_t farthest(const Surface& s, const Piece& piece, Vec3 from) {
  return *std::ranges::max_element(piece.vertices, {},
                                   [&](std::uint32_t v) { return glm::distance(s.position[v], from); });
}

std::uint32_t outermost(const Surface& s, const Piece& piece, Vec3 toward) {
  return *std::ranges::max_element(piece.vertices, {},
                                   [&](std::uint32_t v) { return glm::dot(s.position[v], toward); });
}

/// `stands_for`: so many times its area it has.
void add_leaf(Surface& out, const Surface& s, const Piece& piece, FarLeaf as, float stands_for = 1) {
  if (piece.area <= 1e-12f) return;
  Vec3 middle = piece.middle / piece.area;
  std::uint32_t foot = farthest(s, piece, middle), tip = farthest(s, piece, s.position[foot]);
  // The foot is what is nearer to where the whole begins.
  if (glm::length(s.position[foot]) > glm::length(s.position[tip])) std::swap(foot, tip);
  Vec3 offset = s.position[tip] - s.position[foot];
  float length = glm::length(offset);
  if (length < 1e-7f) return;
  Vec3 axis = offset / length, facing = piece.facing - axis * glm::dot(piece.facing, axis);
  float open = glm::length(piece.facing) / piece.area, covered = piece.area;
  if (open < 0.2f) {  // a closed body shows a quarter of its surface
    covered *= 0.25f;
    facing = glm::cross(axis, reference_axis(axis));
  }
  facing = glm::length(facing) > 1e-9f ? glm::normalize(facing)
                                       : glm::normalize(glm::cross(axis, Vec3(0.3f, 1, 0.2f)));
  // What is narrow grows wider first.
  float wider = std::clamp(0.5f * length * length / covered, 1.0f, std::max(1.0f, stands_for));
  float larger = std::sqrt(stands_for / wider);
  Vec3 across = glm::cross(facing, axis) * (wider * covered / length);
  Vec3 waist = s.position[foot] +
               axis * std::clamp(glm::dot(middle - s.position[foot], axis), 0.2f * length, 0.8f * length);
  float lift = glm::dot(middle - waist, facing);
  waist += facing * lift;
  // A leaf that bends is two triangles with its fold across; else with an edge from its foot to its tip.
  const bool bent = as == FarLeaf::diamond && 2 * std::abs(lift) > glm::length(across);
  if (bent)
    across *= length / (glm::distance(s.position[foot], waist) + glm::distance(waist, s.position[tip]));
  if (as == FarLeaf::triangle) waist = s.position[tip];
  auto first = static_cast<std::uint32_t>(out.position.size());
  auto corner = [&](Vec3 at, std::uint32_t like) {
    out.position.push_back(glm::mix(s.position[foot], at, larger));
    out.normal.push_back(facing);
    if (!s.uv.empty()) out.uv.push_back(s.uv[like]);
  };
  corner(s.position[foot], foot);
  corner(waist - across, outermost(s, piece, -across));
  if (as == FarLeaf::diamond) corner(s.position[tip], tip);
  corner(waist + across, outermost(s, piece, across));
  if (bent) {
    out.triangle.push_back({first, first + 1, first + 3});
    out.triangle.push_back({first + 1, first + 2, first + 3});
    return;
  }
  out.triangle.push_back({first, first + 1, first + 2});
  if (as == FarLeaf::diamond) out.triangle.push_back({first, first + 2, first + 3});
}

}  // namespace

void mark_bends(std::span<const glm::vec4> chain, float within, std::span<char> marks) {
  marks.front() = marks.back() = 1;
  if (chain.size() < 3) return;
  Vec3 start(chain.front()), offset = Vec3(chain.back()) - start;
  float length = glm::length(offset), worst = within;
  std::size_t at = 0;
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    float along =
        length > 0 ? std::clamp(glm::dot(Vec3(chain[i]) - start, offset) / (length * length), 0.0f, 1.0f) : 0;
    float off = glm::distance(Vec3(chain[i]), start + offset * along);
    off += std::abs(chain[i].w - glm::mix(chain.front().w, chain.back().w, along));
    if (off > worst) worst = off, at = i;
  }
  if (at == 0) return;
  mark_bends(chain.first(at + 1), within, marks.first(at + 1));
  mark_bends(chain.subspan(at), within, marks.subspan(at));
}

Skeleton thinned(const Skeleton& s, float least, float tolerance, std::vector<std::int32_t>* kept) {
  auto n = static_cast<std::int32_t>(s.size());
  std::vector<char> keep(s.size(), 0), there(s.size(), 0);
  for (std::int32_t first = 0; first < n;) {
    std::int32_t last = chain_end(s, first), below = s.parent[first];
    bool stays =
        below == Skeleton::kRoot || (there[below] && (s.order[first] == 0 || s.radius[first] >= least));
    for (std::int32_t i = first; i <= last; ++i) there[i] = stays;
    if (stays) {
      keep[first] = keep[last] = 1;
      if (below != Skeleton::kRoot) keep[below] = 1;
    }
    first = last + 1;
  }
  std::vector<glm::vec4> chain;
  for (std::int32_t first = 0; first < n;) {
    std::int32_t last = chain_end(s, first);
    for (std::int32_t from = first, i = first + 1; i <= last; ++i) {
      if (!keep[i]) continue;
      chain.clear();
      for (std::int32_t k = from; k <= i; ++k) chain.emplace_back(s.position[k], s.radius[k]);
      mark_bends(chain, tolerance, std::span(keep).subspan(from, chain.size()));
      from = i;
    }
    first = last + 1;
  }
  Skeleton out;
  std::vector<std::int32_t> index(s.size(), Skeleton::kRoot);
  for (std::int32_t i = 0; i < n; ++i) {
    if (!there[i]) continue;
    std::int32_t below = s.parent[i] == Skeleton::kRoot ? Skeleton::kRoot : index[s.parent[i]];
    index[i] = keep[i] ? out.add(s.position[i], s.radius[i], below, s.order[i]) : below;
    if (keep[i] && kept) kept->push_back(i);
  }
  return out;
}

Pieces pieces_of(const Surface& surface) {
  JoinedSets joined(surface.position.size());
  std::vector<char> loose(surface.position.size(), 1);
  for (auto [a, b, c] : surface.triangle) {
    loose[a] = loose[b] = loose[c] = 0;
    joined.join(a, b), joined.join(b, c);
  }
  Pieces pieces;
  pieces.of.resize(loose.size());
  for (std::uint32_t v = 0; v < loose.size(); ++v)
    pieces.of[v] = loose[v]             ? std::max(pieces.count, 1u) - 1
                   : joined.top(v) == v ? pieces.count++
                                        : pieces.of[joined.top(v)];
  pieces.count = std::max(pieces.count, 1u);
  return pieces;
}

Surface far_leaves(const Surface& surface, const Pieces& pieces, int stride, FarLeaf as, double cover) {
  Surface out;
  std::vector<Piece> list = measured(surface, pieces, false);
  if (stride == 1) {
    for (const Piece& piece : list) add_leaf(out, surface, piece, as);
    return out;
  }
  // Each that is left has an equal part of the area: of large pieces and small ones the large ones remain.
  double all = 0, before = 0;
  for (const Piece& piece : list) all += static_cast<double>(piece.area);
  const double part = all / std::max(1.0, std::round(static_cast<double>(list.size()) / stride));
  for (const Piece& piece : list) {
    double after = before + static_cast<double>(piece.area);
    double parts = std::floor(after / part + 0.5) - std::floor(before / part + 0.5);
    const double for_others = parts * part / (after - before);
    if (parts > 0)
      add_leaf(out, surface, piece, as,
               static_cast<float>(std::max(cover * for_others, std::min(for_others, 1.0))));
    before = after;
  }
  return out;
}

Surface one_far_leaf(const Surface& surface, const Pieces& pieces, FarLeaf as) {
  Surface out;
  add_leaf(out, surface, measured(surface, pieces, true)[0], as);
  if (out.uv.empty()) return out;
  std::vector<Piece> list = measured(surface, pieces, false);
  const Piece& largest = *std::ranges::max_element(list, {}, &Piece::area);
  std::fill(out.uv.begin(), out.uv.end(), largest.uv / std::max(largest.area, 1e-12f));
  return out;
}

Surface with_corners_of(const Surface& surface, std::vector<std::array<std::uint32_t, 3>>&& triangles,
                        std::vector<std::uint32_t>* kept) {
  Surface out;
  out.triangle = std::move(triangles);
  std::vector<std::uint32_t> number(surface.position.size(), UINT32_MAX);
  for (auto& corners : out.triangle)
    for (std::uint32_t& corner : corners) {
      std::uint32_t from = corner;
      if (number[from] == UINT32_MAX) {
        number[from] = static_cast<std::uint32_t>(out.position.size());
        out.position.push_back(surface.position[from]);
        out.normal.push_back(surface.normal[from]);
        if (!surface.uv.empty()) out.uv.push_back(surface.uv[from]);
        if (kept) kept->push_back(from);
      }
      corner = number[from];
    }
  return out;
}

namespace {

/// An error in metres as meshoptimizer takes it.
float share_of_extent(double error, const std::vector<Vec3>& at) {
  return static_cast<float>(error) / meshopt_simplifyScale(&at.data()->x, at.size(), sizeof(Vec3));
}

/// Either method of meshoptimizer, to that number of triangles.
template <class Simplify>
Surface fewer(const Surface& surface, std::size_t triangles, const Simplify& simplify,
              std::vector<std::uint32_t>* kept = nullptr) {
  triangles = std::max<std::size_t>(triangles, 4);
  if (surface.triangle.size() <= triangles) return surface;
  std::vector<std::array<std::uint32_t, 3>> left(surface.triangle.size());
  std::size_t corners =
      simplify(left.data()->data(), surface.triangle.data()->data(), 3 * surface.triangle.size(),
               &surface.position.data()->x, surface.position.size(), sizeof(Vec3), 3 * triangles);
  left.resize(corners / 3);
  return with_corners_of(surface, std::move(left), kept);
}

}  // namespace

Surface simplified(const Surface& surface, std::size_t triangles) {
  return fewer(surface, triangles, [](auto... a) { return meshopt_simplifySloppy(a..., 1.0f, nullptr); });
}

Surface reduced(const Surface& surface, std::size_t triangles, std::vector<std::uint32_t>* kept) {
  return fewer(
      surface, triangles, [](auto... a) { return meshopt_simplify(a..., 0.05f, 0u, nullptr); }, kept);
}

Surface reduced_within(const Surface& surface, double error, std::size_t least, std::size_t most,
                       std::vector<std::uint32_t>* kept) {
  float share = share_of_extent(error, surface.position);
  std::vector<std::uint32_t> left;
  Surface within = fewer(
      surface, least, [&](auto... a) { return meshopt_simplify(a..., share, 0u, nullptr); }, &left);
  if (within.triangle.size() > most) return reduced(surface, most, kept);
  if (kept) *kept = std::move(left);
  return within;
}

Surface reduced_tiles(const Surface& surface, std::span<const std::uint32_t> tile,
                      std::span<const double> error) {
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  std::vector<Triangles> tiles(error.size());
  for (std::size_t t = 0; t < tile.size(); ++t) tiles[tile[t]].push_back(surface.triangle[t]);
  parallel_for(tiles.size(), [&](std::size_t k) {
    Triangles& own = tiles[k];
    std::vector<std::uint32_t> vertex;
    for (const auto& t : own) vertex.insert(vertex.end(), t.begin(), t.end());
    std::ranges::sort(vertex);
    vertex.erase(std::unique(vertex.begin(), vertex.end()), vertex.end());
    std::vector<Vec3> at;
    for (std::uint32_t v : vertex) at.push_back(surface.position[v]);
    for (auto& t : own)
      for (std::uint32_t& v : t)
        v = static_cast<std::uint32_t>(std::ranges::lower_bound(vertex, v) - vertex.begin());
    if (own.empty()) return;
    Triangles left(own.size());
    left.resize(meshopt_simplify(left.data()->data(), own.data()->data(), 3 * own.size(), &at.data()->x,
                                 at.size(), sizeof(Vec3), 3, share_of_extent(error[k], at),
                                 meshopt_SimplifyLockBorder, nullptr) /
                3);
    for (auto& t : left)
      for (std::uint32_t& v : t) v = vertex[v];
    own = std::move(left);
  });
  return with_corners_of(surface, joined(tiles));
}

}  // namespace frond
