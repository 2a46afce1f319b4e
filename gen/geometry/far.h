#pragma once

#include "model/skeleton.h"
#include "model/surface.h"

namespace frond {

/// Branches as they are seen from afar: without those that begin thinner than `least` metres (the stem
/// stays), and without nodes that lie within `tolerance` metres of the line that would join their neighbours
/// (Douglas and Peucker 1973) and are as thick as that. Forks that are left stay where they are. `kept` is
/// told which nodes these are.
Skeleton thinned(const Skeleton& skeleton, float least, float tolerance,
                 std::vector<std::int32_t>* kept = nullptr);

/// Which connected piece of a surface each vertex belongs to, counted from 0 in the order of the vertices;
/// one of no triangle goes with the piece before it.
struct Pieces {
  std::vector<std::uint32_t> of;
  std::uint32_t count = 0;
};
Pieces pieces_of(const Surface& surface);

/// What stands for a leaf from afar: a diamond of two triangles, or one triangle on its tip.
enum class FarLeaf { diamond, triangle };

/// Each connected piece as such a leaf: as long, of the same area, facing the same way. A round body becomes
/// one that covers what the body covers. `uv` are those of the corners' places. With `stride` one of so many
/// pieces stands for all of them, grown about its foot to their area.
Surface far_leaves(const Surface& surface, const Pieces& pieces, int stride = 1,
                   FarLeaf as = FarLeaf::diamond);

/// The whole surface as one of them, all of which has the `uv` of the middle of its largest piece.
Surface one_far_leaf(const Surface& surface, const Pieces& pieces, FarLeaf as = FarLeaf::diamond);

/// About so many of a body's triangles, at least 4 where it has them: its corners with their normals and
/// `uv`, those of each cell of a grid drawn together (meshoptimizer's sloppy simplification).
Surface simplified(const Surface& surface, std::size_t triangles);

/// The same by drawing edges together where that changes the shape least (Garland and Heckbert 1997), so that
/// it stays one body; for what is seen from near.
/// `kept` is told which vertices are left, where not all are.
Surface reduced(const Surface& surface, std::size_t triangles, std::vector<std::uint32_t>* kept = nullptr);

}  // namespace frond
