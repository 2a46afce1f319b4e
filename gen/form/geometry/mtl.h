#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/polygon_mesh.h"

namespace frond {

/// Reads the files that an OBJ file names, which lie in its folder or below it: those of its materials and
/// their pictures. What is missing becomes a note. Appends their paths to `noted` and what they hold to
/// `content`, where these are given.
void read_materials(const std::filesystem::path& obj, PolygonMesh& mesh,
                    std::vector<std::filesystem::path>* noted, std::string* content);

}  // namespace frond
