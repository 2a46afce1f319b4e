#pragma once

#include <string>
#include <vector>

#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// Appends `texture{...}` of a chunk: the skin of number `index`, younger toward a tip, carried to where the
/// skin has moved.
void append_chunk_texture(std::string& text, const PovSpace& space, const Specimen& b, const Pose& pose,
                          Chunk chunk, std::size_t index);

/// The branches of a tree that wears a bark as a picture: one mesh with its texture; empty while none of it
/// has grown. Where the eye is near, its furrows are let in.
ObjectText coat_text(const PovSpace& space, const Specimen& tree, const Pose& pose, Vec3 eye);

/// Which nodes it leaves out, for they are of twigs too thin for a picture.
std::vector<bool> coatless(const Specimen& tree);

}  // namespace frond
