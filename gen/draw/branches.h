#pragma once

#include <vector>

#include "draw/sweep.h"
#include "world/specimen.h"

// How the branches of a specimen are drawn.

namespace frond {

enum class BranchForm {
  none,
  sweeps,  ///< chunks, see cut_chunks()
  coat,    ///< one mesh with a picture, and sweeps where they are too thin for that
  body     ///< fused, or of cubes
};
BranchForm branch_form(const Specimen& specimen);

/// How finely chunks are cut.
ChunkOptions chunk_options(const Specimen& specimen);

/// Whether a chunk is a limb thick enough to show a bark that lies along it, and not upright, where it does
/// so anyway.
bool slanted(const Specimen& plant, const Chunk& chunk);

/// Whether all branches of a plant have one and the same texture in the whole film, which then stands on
/// their union.
bool one_texture(const Specimen& plant);

/// The branches of a tree that wears a bark as a picture; empty while none of it has grown. Where the eye is
/// near, its furrows are let in.
Surface coat_surface(const Specimen& tree, const Pose& pose, Vec3 eye);

/// Which nodes it leaves out: those of twigs too thin for a picture.
std::vector<bool> coatless(const Specimen& tree);

}  // namespace frond
