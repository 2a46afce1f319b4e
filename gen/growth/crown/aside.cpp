#include "crown/aside.h"

namespace frond {

void bend_aside(Crown& crown, const Detour& detour) {
  constexpr std::int32_t kCut = -2;
  const Skeleton& s = crown.skeleton;
  Skeleton kept;
  kept.reserve(s.size());
  std::vector<Vec3> shift(s.size(), Vec3(0));
  std::vector<std::int32_t> index(s.size(), kCut);
  for (std::size_t i = 0; i < s.size(); ++i) {
    std::int32_t below = s.parent[i];
    Vec3 at = s.position[i];
    if (below != Skeleton::kRoot) {
      std::size_t p = static_cast<std::size_t>(below);
      below = index[p];
      if (below == kCut) continue;
      std::optional<Vec3> way = detour(kept.position[below], at + shift[p], s.radius[i] + kBarkGap);
      if (!way) continue;
      shift[i] = *way - at;
      at = *way;
    }
    index[i] = kept.add(at, s.radius[i], below, s.order[i]);
  }
  std::erase_if(crown.leaves, [&](const LeafSite& leaf) { return index[leaf.node] == kCut; });
  for (LeafSite& leaf : crown.leaves) {
    leaf.position += shift[leaf.node];
    leaf.node = index[leaf.node];
  }
  crown.skeleton = std::move(kept);
}

}  // namespace frond
