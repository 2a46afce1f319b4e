#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "crown/weber_penn.h"

namespace frond {

/// A species as the file format of the tree generator Arbaro stores it.
struct ArbaroSpecies {
  std::string name;
  WeberPenn tree;
  std::string leaf_shape = "disc";  ///< Arbaro's name of the shape
};

/// Reads `<arbaro><species><param name='Shape' value='7'/>...`. Missing parameters keep Arbaro's defaults.
/// Unknown names and invalid values are errors with their line and the nearest name. Parameters of Arbaro's
/// meshes (Smooth) are read and ignored.
Result<ArbaroSpecies> read_arbaro(std::string_view xml, const std::string& file_name);

/// All known parameter names.
std::vector<std::string> arbaro_names();

}  // namespace frond
