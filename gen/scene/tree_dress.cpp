#include "scene/tree_dress.h"

#include "core/parallel.h"

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

Result<std::vector<Picture>> draw_pictures(const Preset& preset, const Watch& watch) {
  const std::vector<Organism>& organisms = preset.organisms;
  watch.begin("texture", organisms.size());
  std::vector<Result<std::vector<Picture>>> drawn(organisms.size(), std::vector<Picture>{});
  parallel_for(organisms.size(), [&](std::size_t i) {
    if (organisms[i].count > 0) drawn[i] = pictures(organisms[i]);
    watch.step();
  });
  std::vector<Picture> all;
  for (Result<std::vector<Picture>>& part : drawn) {
    if (!part) return part.errors();
    for (Picture& picture : *part) all.push_back(std::move(picture));
  }
  return all;
}

}  // namespace frond
