#pragma once

#include <string>

#include "bake/bake.h"
#include "organisms/organism.h"

namespace frond {

/// What an organism is made of, on a ball, as a PNG: the bark or skin of its branches, or the material of its
/// first body, which is grown for this. An error where it has neither, or POV-Ray fails.
Result<std::string> material_ball(const Organism& organism, const BakeOptions& options);

}  // namespace frond
