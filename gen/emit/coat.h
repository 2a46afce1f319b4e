#pragma once

#include <string>

#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// The branches of a tree that wears a bark as a picture: one mesh with its texture; empty while none of it
/// has grown.
std::string coat_text(const PovSpace& space, const Branches& tree, const Pose& pose);

}  // namespace frond
