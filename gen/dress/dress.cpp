#include "dress/dress.h"

#include <algorithm>
#include <iterator>

namespace frond {

LeafLook leaves_of(const TreeDress& dress) {
  return dress.season ? with_seasons(dress.leaves, *dress.season) : dress.leaves;
}

Dress dress_of(const TreeDress& tree, bool leafy) {
  Dress dress;
  dress.look.bark = tree.bark;
  dress.look.coat = tree.coat;
  if (leafy) dress.look.leaves = leaves_of(tree);
  dress.season = tree.season;
  dress.motion = {tree.growth, tree.wave, {}, 1};
  dress.variation = tree.bark.variation;
  return dress;
}

std::vector<Drawing> drawings(const Look& look) {
  std::vector<Drawing> all;
  if (look.leaves) all = leaf_drawings(*look.leaves);
  for (const LeafLook& organ : look.organs) std::ranges::move(leaf_drawings(organ), std::back_inserter(all));
  std::ranges::copy(look.pictures, std::back_inserter(all));
  if (look.coat) all.push_back(bark_drawing(*look.coat));
  return all;
}

}  // namespace frond
