#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/assets.h"
#include "core/result.h"
#include "geometry/polygon_mesh.h"
#include "model/surface.h"

namespace frond {

/// What kind of file bytes are that hold no mesh Frond reads, such as "an FBX file"; empty where they may be
/// an OBJ text or are of another format that is read.
std::string foreign_format(std::string_view bytes);

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
