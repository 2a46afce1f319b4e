#pragma once

#include <string>

#include "emit/levels.h"
#include "emit/pov.h"

namespace frond {

/// For a stretch of the film: the includes of the models and the tints of the stands, and all copies of
/// stands that stand still.
std::string still_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan,
                              std::size_t stretch);
/// The copies of stands that sway in the wind, in a frame at its time.
std::string swaying_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, int frame,
                                double time);

}  // namespace frond
