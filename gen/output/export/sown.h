#pragma once

#include <vector>

#include "export/maker.h"

namespace frond {

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

}  // namespace frond
