#pragma once

#include <string>

#include "scene/scene.h"

namespace frond {

/// How often a closed surface goes round a place: about 1 inside of it, 0 outside, in between near the gaps
/// of one that is not quite closed (Jacobson, Kavan and Sorkine-Hornung 2013).
double winding_number(const Surface& surface, Vec3 place);

/// Says that the camera lies inside of a body, a branch or a stone, which one, and when first; empty where
/// it does not. What grows in the film is asked for at its end only.
std::string inside_something(const Scene& scene);

}  // namespace frond
