#pragma once

#include <string>

#include "draw/draw_list.h"
#include "emit/pov.h"
#include "scene/scene.h"

// Rain and snow.

namespace frond {

/// What rain adds to a setting at a time: the textures of water on things, the rings on it, and mist.
std::string rain_text(const Scene& scene, double time);

/// What falls at a time: drops of rain as one mesh, and flakes with the powder that boughs have dropped as
/// another; none where there are none.
std::string falling_text(const PovSpace& space, const Scene& scene, double time);

/// The snow on the branches of an organism; `pixel`: metres.
ObjectText bough_snow_text(const PovSpace& space, const DrawList& drawn, double time, double pixel);

/// Declares what it is made of; empty where no branch carries any.
std::string bough_snow_declarations(const PovSpace& space, const Scene& scene);

}  // namespace frond
