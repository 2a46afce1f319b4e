#pragma once

#include <vector>

#include "export/maker.h"

namespace frond {

/// Branches of one material, and the node of the skeleton that each vertex belongs to.
struct BranchPart {
  ExportPart part;
  std::vector<std::int32_t> node = {};
};

/// The branches of a specimen in a pose, as its style has them: a part for each of their colours, with paler
/// tips. Tubes have about so many triangles at most.
Result<std::vector<BranchPart>> branch_parts(Maker& maker, const Specimen& specimen, const Pose& pose,
                                             double triangles);

}  // namespace frond
