#pragma once

#include "model/surface.h"
#include "rocks/blob_cells.h"

namespace frond {

/// The implicit surface of blobs as triangles: dual marching cubes (Schaefer and Warren 2004) on the octree
/// of `cut_cells`. The cubes are those between the middles of neighbouring cells, some of them with corners
/// that coincide, so that cells of different size meet without cracks. Closed, without edges of more than two
/// triangles, turned outward; vertices lie on the surface to rounding and carry the normal of the field.
/// Empty where nothing is inside.
Surface blob_surface(const Blobs& shape, const CellOptions& options = {});

/// The surface of cells that are cut already.
Surface blob_surface(const Blobs& shape, const BlobCells& cells);

}  // namespace frond
