#pragma once

#include <string>

#include "core/assets.h"
#include "core/result.h"
#include "geometry/polygon_mesh.h"
#include "model/surface.h"

namespace frond {

/// The mesh of a file, whose format is told by what it holds, not by its name: Wavefront OBJ, PLY, STL or
/// GLB. Files of materials that an OBJ names, and pictures that these name, are read if they lie in the same
/// folder or below it; what is missing becomes a note. `content`, if given, is extended by what those files
/// hold.
Result<PolygonMesh> read_mesh_file(const NamedFile& file, std::string* content = nullptr);

/// A frame in which a mesh stands on the origin, y up, its longest side one unit long.
MeshFrame unit_frame(const PolygonMesh& mesh);

/// Reads the mesh of a file in its unit_frame(), for properties that name one.
Errors load_unit_mesh(const NamedFile& file, Surface& mesh);

}  // namespace frond
