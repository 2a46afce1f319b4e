#include "scene/tree_dress.h"

namespace frond {

namespace {

double wear(Branches& branches, const TreeDress& dress) {
  branches.bark = dress.bark;
  branches.coat = dress.coat;
  branches.season = dress.season;
  branches.motion = {dress.growth, dress.wave, {}, 1};
  return dress.bark.variation;
}

}  // namespace

double wear(Branches& branches, const WeberPennParams& params) {
  branches.lobes = params.tree.lobes;
  branches.lobe_depth = params.tree.lobe_depth;
  return wear(branches, params.dress);
}

double wear(Branches& branches, const ColonizedParams& params) { return wear(branches, params.dress); }

}  // namespace frond
