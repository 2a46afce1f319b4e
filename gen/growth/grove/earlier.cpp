#include "grove/earlier.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace frond {

namespace {

/// The radius at the end of the year before `years`.
float radius_then(const GrownTree& tree, std::size_t i, int years) {
  // The foot has its first ring at the end of the year in which it is planted.
  int first = static_cast<int>(i == 0 ? std::floor(tree.born[i]) + 1 : std::ceil(tree.born[i]));
  std::uint32_t rings = tree.first_ring[i + 1] - tree.first_ring[i];
  auto k = std::min(static_cast<std::uint32_t>(std::max(years - first, 0)), rings - 1);
  return rings > 0 ? tree.ring[tree.first_ring[i] + k] : tree.radius[i];
}

}  // namespace

GrownTree earlier(const GrownTree& tree, int years) {
  assert(years > 0 && tree.first_ring.size() == tree.size() + 1);
  GrownTree then;
  auto end = static_cast<float>(years);
  std::vector<std::int32_t> index(tree.size(), GrownTree::kRoot);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    // What the storm of a year breaks is dropped in that year, and on its way in the next one.
    if (tree.born[i] > end || tree.fell[i] < end + 1) continue;
    std::int32_t p = tree.parent[i];
    assert((p == GrownTree::kRoot || index[p] != GrownTree::kRoot) && "what bears a part outlasts it");
    index[i] = static_cast<std::int32_t>(then.size());
    then.tip.push_back(tree.tip[i]);
    then.side.push_back(tree.side[i]);
    then.parent.push_back(p == GrownTree::kRoot ? p : index[p]);
    then.radius.push_back(radius_then(tree, i, years));
    then.born.push_back(tree.born[i]);
    then.died.push_back(tree.died[i] < end ? tree.died[i] : GrownTree::kNever);
    then.fell.push_back(GrownTree::kNever);
    then.light.push_back(tree.light[i]);
    then.order.push_back(tree.order[i]);
    then.leads.push_back(then.died.back() == GrownTree::kNever);
  }
  for (std::size_t i = 1; i < tree.size(); ++i) {
    auto p = static_cast<std::size_t>(tree.parent[i]);
    // A bud that has sprouted is gone, also where its shoot has fallen.
    bool sprouted = tree.born[i] <= end && tree.order[i] == tree.order[p];
    if (sprouted && index[p] != GrownTree::kRoot) then.leads[static_cast<std::size_t>(index[p])] = false;
  }
  for (Scar scar : tree.scars) {
    if (scar.fell >= end + 1 || index[scar.on] == GrownTree::kRoot) continue;
    scar.on = static_cast<std::uint32_t>(index[scar.on]);
    then.scars.push_back(scar);
  }
  then.sizes.assign(tree.sizes.begin(),
                    tree.sizes.begin() + std::min<std::ptrdiff_t>(years, std::ssize(tree.sizes)));
  then.grown = tree.grown, then.broken = tree.broken, then.stem_broke = tree.stem_broke,
  then.bytes = tree.bytes;
  return then;
}

}  // namespace frond
