#pragma once

#include <string>
#include <string_view>

#include "dress/dress.h"
#include "export/export_scene.h"
#include "organisms/organism.h"

namespace frond {

/// A name of letters, digits, - and _ alone; `otherwise` where nothing is left of it.
std::string plain_name(const std::string& name, std::string_view otherwise);

/// Whether a tissue is a thin sheet, seen from both sides.
bool is_leaf(Tissue tissue);

}  // namespace frond
