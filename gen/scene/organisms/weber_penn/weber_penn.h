#pragma once

#include "appearance/appearance.h"
#include "core/assets.h"
#include "crown/weber_penn.h"
#include "organisms/tree_parts.h"

namespace frond {

/// A tree by the parameters of Weber and Penn.
struct WeberPennParams {
  WeberPenn tree;
  TreeGuide guide;  ///< of the first trunk
  FileName arbaro;  ///< an Arbaro file whose values replace `tree`, relative to the preset's folder
  TreeAppearance appearance;
};

/// One tree, its foot at the origin, round what is in its way.
Result<Model> grow_weber_penn_tree(const WeberPennParams& params, Seed seed, const Detour& detour = {});

}  // namespace frond
