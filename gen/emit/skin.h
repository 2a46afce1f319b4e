#pragma once

#include <string>

#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// Appends `texture{...}` of a chunk: the skin of number `index`, younger toward a tip, carried to where the
/// skin has moved.
void append_chunk_texture(std::string& text, const PovSpace& space, const Specimen& b, const Pose& pose,
                          Chunk chunk, std::size_t index);

}  // namespace frond
