#pragma once

#include <array>

#include "images/raster.h"
#include "scene/scene.h"

namespace frond {

/// What the camera will see at a time, in seconds, of the film's size: bits of surface in their colours, and
/// the sun's shadows. No leaf has a picture, no surface a texture; what is sown stands as the room that it
/// takes, for its models are not grown for this. Half a second for a tree of a hundred thousand leaves.
Raster quick_look(const Scene& scene, double time);

/// A quick look at a scene at a time, in seconds, of another width and height in pixels.
Raster quick_look(const Scene& scene, double time, std::array<int, 2> size);

}  // namespace frond
