#include <algorithm>

#include "core/keep.h"
#include "pruning/edits.h"
#include "pruning/keep_blades.h"

namespace frond {

namespace {

/// For each node, the share of its segment, 0..1, from which on it is bare; above 1: it is bare nowhere.
std::vector<float> bare_from(const Model& model, std::span<const Edit> edits) {
  const std::vector<std::int32_t>& parent = model.skeleton.parent;
  const std::vector<AxisNode> axes = axis_nodes(model);
  const Branching plant{parent, axes};
  const std::vector<std::int32_t> starts = axis_starts(plant);
  std::vector<float> from(parent.size(), 2);
  for (const Edit& edit : edits) {
    if (!edit.bare) continue;
    Result<BranchPlace> place = find_place(plant, starts, edit.at);
    if (!place) continue;
    from[place->node] = std::min(from[place->node], place->within);
    std::vector<std::uint8_t> beyond(parent.size());
    beyond[place->node] = 1;
    for (auto i = static_cast<std::size_t>(place->node) + 1; i < parent.size(); ++i)
      if (parent[i] != Skeleton::kRoot && beyond[parent[i]]) beyond[i] = 1, from[i] = 0;
  }
  return from;
}

}  // namespace

void strip_model(Model& model, std::span<const Edit> edits) {
  if (std::ranges::none_of(edits, &Edit::bare)) return;
  const Skeleton& s = model.skeleton;
  const std::vector<float> from = bare_from(model, edits);
  auto stays = [&](std::int32_t node, Vec3 at) -> std::uint8_t {
    if (node == Skeleton::kRoot || from[node] > 1) return true;
    if (from[node] <= 0 || s.parent[node] == Skeleton::kRoot) return false;
    const Vec3 foot = s.position[s.parent[node]], along = s.position[node] - foot;
    const float length2 = glm::dot(along, along);
    return length2 > 0 && glm::dot(at - foot, along) / length2 < from[node];
  };
  Organs& o = model.organs;
  std::vector<std::uint8_t> stay(o.size());
  for (std::size_t i = 0; i < o.size(); ++i)
    stay[i] = model.prototypes[o.prototype[i]].name == kSawn || stays(o.node[i], o.position[i]);
  keep(stay, o.prototype, o.position, o.turn, o.scale, o.node, o.birth, o.color, o.id, o.loose, o.supple);
  Blades& b = model.blades;
  stay.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) stay[i] = stays(b.node[i], b.foot[i]);
  keep_blades(b, stay);
}

}  // namespace frond
