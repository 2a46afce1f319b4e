#pragma once

#include "model/surface.h"
#include "rocks/blob_cells.h"

namespace frond {

/// The implicit surface of blobs as triangles: dual marching cubes (Schaefer and Warren 2004) on the octree
/// of `cut_cells`. The cubes connect the middles of neighbouring cells; some have coinciding corners, so that
/// cells of different size meet without cracks. Closed, every edge has two triangles, oriented outward;
/// vertices are on the surface to rounding, with the normal of the field. Empty if there is no inside.
Surface blob_surface(const Blobs& shape, const CellOptions& options = {});

/// The surface for existing cells.
Surface blob_surface(const Blobs& shape, const BlobCells& cells);

}  // namespace frond
