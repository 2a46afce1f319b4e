#pragma once

#include <optional>
#include <string>

#include "draw/levels.h"
#include "emit/pov.h"

namespace frond {

/// The `#include` lines of the models that a stretch of the film shows; with a time, of those whose copies
/// come and go, and without one of the others.
std::string model_includes_text(const Scene& scene, const CopyPlan& plan, std::size_t stretch,
                                std::optional<double> time = {});
/// For a stretch of the film: the tints of all copies and those copies that stand still.
ObjectText still_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan,
                             std::size_t stretch);
/// The copies that sway in the wind, in a frame at its time.
ObjectText swaying_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, int frame,
                               double time);

}  // namespace frond
