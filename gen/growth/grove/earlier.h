#pragma once

#include "grove/grove.h"

namespace frond {

/// A tree as it stood after the first `years` years of its grove, 1 or more: as it would be had it grown no
/// longer and kept no history. The tree must have its history. Only `light`, `grown`, `broken`, `stem_broke`
/// and `bytes` stay those of its whole life.
GrownTree earlier(const GrownTree& tree, int years);

}  // namespace frond
