#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "geometry/polygon_mesh.h"

namespace frond {

/// A PLY file, ASCII or binary of either byte order: faces or strips of triangles over places, with normals,
/// texture coordinates and colours of the places, if there are any.
Result<PolygonMesh> read_ply_mesh(std::string_view bytes, const std::string& name);

/// An STL file, ASCII or binary. Corners at the very same place are one; solids of a text are objects.
Result<PolygonMesh> read_stl_mesh(std::string_view bytes, const std::string& name);

/// Whether bytes are as long as a binary STL file says at its beginning.
bool is_binary_stl(std::string_view bytes);

/// A GLB file (binary glTF 2.0): all meshes of its scene where its nodes place them, at rest, with normals,
/// texture coordinates, colours and materials. Meshes that are compressed by an extension are named in an
/// error.
Result<PolygonMesh> read_glb_mesh(std::string_view bytes, const std::string& name);

/// Reads the files that an OBJ file names, which lie in its folder or below it: those of its materials and
/// their pictures. What is missing becomes a note. Appends their paths to `noted` and what they hold to
/// `content`, where these are given.
void read_materials(const std::filesystem::path& obj, PolygonMesh& mesh,
                    std::vector<std::filesystem::path>* noted, std::string* content);

/// How the name of a file ends that holds what these bytes of a mesh are: ".obj", ".ply", ".stl" or ".glb".
const char* mesh_ending(std::string_view bytes);

}  // namespace frond
