#pragma once

#include <vector>

#include "draw/branches.h"
#include "export/maker.h"

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

}  // namespace frond
