#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "crown/weber_penn.h"

namespace frond {

/// A species as the tree generator Arbaro stores it.
struct ArbaroSpecies {
  std::string name;
  WeberPenn tree;
  std::string leaf_shape = "disc";  ///< its name for it
};

/// Reads `<arbaro><species><param name='Shape' value='7'/>...`. Parameters that are missing keep Arbaro's
/// defaults. Unknown ones, and values that are none, are errors, each with its line and the nearest name.
/// What says how Arbaro meshes a tree (Smooth) is read and has no effect.
Result<ArbaroSpecies> read_arbaro(std::string_view xml, const std::string& file_name);

/// Every name of a parameter that it knows.
std::vector<std::string> arbaro_names();

}  // namespace frond
