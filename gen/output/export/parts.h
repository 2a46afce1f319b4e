#pragma once

#include <span>
#include <vector>

#include "draw/branches.h"
#include "export/maker.h"

// What the organisms of a scene are made of when they are exported.

namespace frond {

/// Branches of one material, and the node of the skeleton that each vertex belongs to.
struct BranchPart {
  ExportPart part;
  std::vector<std::int32_t> node = {};
};

/// The branches of an organism, as its style has them: a part for each of their colours, with paler
/// tips. Tubes have about so many triangles at most, and thin roots at the foot a few more, which are added
/// to maker.spare.
Result<std::vector<BranchPart>> branch_parts(Maker& maker, const DrawnBranches& branches, double triangles);

/// What such bodies of an organism that wears a look are made of, one part a material, where they stand;
/// `keys` are its bodies in the shapes of the scene's keys but the last.
std::vector<ExportPart> body_parts(Maker& maker, const Look& look, std::span<const DrawnBody> bodies,
                                   std::span<const Solids> keys = {});

/// Whether a model is nothing but organs and bodies that are those of another, elsewhere and in other shapes
/// of the same triangles, as the fish of a school and the valves of a clam are.
bool is_same_swarm(const Model& a, const Model& b);

/// The organs of a swarm in about so many triangles, carried to where they are at the scene's keys but the
/// last.
std::map<std::string, std::vector<ExportPart>> swarm_parts(Maker& maker, const Look& look, const Model& last,
                                                           std::span<const Model> keys, double triangles);

/// Adds what is sown in a scene and there at a time: each model that has copies once, fully grown, drawn as
/// finely as its size asks for, as one mesh, and a placement for each copy. Copies stand still and share the
/// colours of their model.
Errors add_sown(Maker& maker, const Scene& scene, double time);

/// The branches of a model, its foot at the origin, and where its copies stand.
struct SownBranches {
  Skeleton rest;
  std::vector<ExportPlacement> copies;  ///< their `mesh` means nothing
};

/// All that are sown in a scene, there at a time, and have branches.
Result<std::vector<SownBranches>> sown_branches(const Scene& scene, double time);

/// Draws the levels of detail that are pictures, after the materials have theirs: of an organism's leaves
/// some sets of three pictures that cross, seen from the front, the side and above, each of a bough; at the
/// last level one set of the whole, of three sides and the top. As much of them is opaque, and leaves of
/// other levels are as large, as lets them cover what the first level does.
Errors add_crossed_levels(Maker& maker);

}  // namespace frond
