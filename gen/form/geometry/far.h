#pragma once

#include <glm/vec4.hpp>
#include <span>

#include "model/skeleton.h"
#include "model/surface.h"

namespace frond {

/// Marks with 1 those points of a chain that are farther than `within` metres from the line between their
/// neighbours that are marked (Douglas and Peucker 1973), its ends always. w is their radius: by how much it
/// differs counts, too.
void mark_bends(std::span<const glm::vec4> chain, float within, std::span<char> marks);

/// Branches simplified for a far view: without those that begin thinner than `least` metres (the stem stays),
/// and without nodes within `tolerance` metres of the line between their neighbours (Douglas and Peucker
/// 1973) and of about the same thickness. Remaining forks stay in place. `kept` receives the indices of the
/// remaining nodes.
Skeleton thinned(const Skeleton& skeleton, float least, float tolerance,
                 std::vector<std::int32_t>* kept = nullptr);

/// The connected piece of a surface that each vertex belongs to, numbered from 0 in order of the vertices; a
/// vertex without triangles belongs to the piece before it.
struct Pieces {
  std::vector<std::uint32_t> of;
  std::uint32_t count = 0;
};
Pieces pieces_of(const Surface& surface);

/// The shape that replaces a leaf in a far view: a diamond of two triangles, or one triangle on its tip.
enum class FarLeaf { diamond, triangle };

/// Each connected piece as a far leaf of the same length, area and orientation. A round body becomes a leaf
/// of the same projected area. `uv` are taken at the corners. With `stride` n, one of some n pieces
/// represents them, scaled about its foot to their area, or to the share `cover` of it where it is smaller.
Surface far_leaves(const Surface& surface, const Pieces& pieces, int stride = 1,
                   FarLeaf as = FarLeaf::diamond, double cover = 1);

/// The whole surface as one far leaf, with the `uv` of the middle of its largest piece.
Surface one_far_leaf(const Surface& surface, const Pieces& pieces, FarLeaf as = FarLeaf::diamond);

/// A mesh of these triangles of another one, with the vertices that they have: `kept` receives those.
Surface with_corners_of(const Surface& surface, std::vector<std::array<std::uint32_t, 3>>&& triangles,
                        std::vector<std::uint32_t>* kept = nullptr);

/// A mesh of about `triangles` triangles, at least 4 if it has them: the corners in each cell of a grid are
/// merged, with normals and `uv` (meshoptimizer's sloppy simplification).
Surface simplified(const Surface& surface, std::size_t triangles);

/// A mesh of about `triangles` triangles, made by collapsing the edges that change the shape least (Garland
/// and Heckbert 1997), which keeps it one body; for near views. `kept` receives the remaining vertices, where
/// some are gone.
Surface reduced(const Surface& surface, std::size_t triangles, std::vector<std::uint32_t>* kept = nullptr);

/// A mesh that reduced() makes, of as few triangles as leave the shape within about `error` metres of where
/// it was: from about `least` to about `most`.
Surface reduced_within(const Surface& surface, double error, std::size_t least, std::size_t most,
                       std::vector<std::uint32_t>* kept = nullptr);

/// A surface whose tiles are each reduced by an error of their own, metres; edges between tiles stay, so the
/// tiles meet. `tile` is that of each triangle.
Surface reduced_tiles(const Surface& surface, std::span<const std::uint32_t> tile,
                      std::span<const double> error);

}  // namespace frond
