#include "field/whole.h"

#include "core/joined_sets.h"

namespace frond {

namespace {

std::vector<std::int32_t> root_of_nodes(const BranchVolume& boughs) {
  std::vector<std::int32_t> root;
  for (const RoundCone& cone : boughs.cones) {
    auto node = static_cast<std::size_t>(cone.node);
    if (node >= root.size()) root.resize(node + 1, 0);
    root[node] = cone.root;
  }
  return root;
}

}  // namespace

std::vector<bool> outsides(const Surface& s, std::span<const std::int32_t> node, const BranchVolume& boughs) {
  JoinedSets joined(s.position.size());
  for (auto [a, b, c] : s.triangle) joined.join(a, b), joined.join(b, c);
  std::vector<double> volume(s.position.size());  // of each piece, at the vertex that stands for it
  for (auto [a, b, c] : s.triangle)
    volume[joined.top(a)] +=
        glm::dot(DVec3(s.position[a]), glm::cross(DVec3(s.position[b]), DVec3(s.position[c])));
  // The largest piece of each root.
  std::vector<std::int32_t> root = root_of_nodes(boughs);
  std::vector<std::uint32_t> largest(root.size(), UINT32_MAX);
  for (std::uint32_t v = 0; v < s.position.size(); ++v) {
    std::uint32_t piece = joined.top(v);
    std::uint32_t& best = largest[root[static_cast<std::size_t>(node[v])]];
    if (volume[piece] > 0 && (best == UINT32_MAX || volume[piece] > volume[best])) best = piece;
  }
  std::vector<bool> kept(s.position.size()), outside(s.triangle.size());
  for (std::uint32_t piece : largest)
    if (piece != UINT32_MAX) kept[piece] = true;
  for (std::size_t t = 0; t < s.triangle.size(); ++t) outside[t] = kept[joined.top(s.triangle[t][0])];
  return outside;
}

}  // namespace frond
