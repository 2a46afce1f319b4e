#pragma once

#include <string>

#include "draw/draw_list.h"
#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// The flakes that show at a time, and the powder that boughs have dropped, as one mesh; none where there are
/// none.
std::string flakes_text(const PovSpace& space, const Scene& scene, double time);

/// The snow on the branches of an organism; `pixel`: metres.
ObjectText bough_snow_text(const PovSpace& space, const DrawList& drawn, double time, double pixel);

/// Declares what it is made of; empty where no branch carries any.
std::string bough_snow_declarations(const PovSpace& space, const Scene& scene);

}  // namespace frond
