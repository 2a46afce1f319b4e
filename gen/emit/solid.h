#pragma once

#include <string>
#include <vector>

#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// The names of the povinc files that the solids of a scene need, each once, as `stone` for frond_stone.inc.
std::vector<std::string_view> solid_includes(const Scene& scene);

/// The `texture{...}` of a material, and what is inside; the name of the povinc file that it needs.
std::string material_text(const Material& material);
std::string_view material_include(const Material& material);

/// Declares the shapes of all solids and places them, but for those that a film sees grow; the same in each
/// frame.
std::string solids_text(const PovSpace& space, const Scene& scene);

/// The solids of one organism that a film sees grow, as they are at a time.
std::string growing_solids_text(const PovSpace& space, const Specimen& b, double time);

}  // namespace frond
