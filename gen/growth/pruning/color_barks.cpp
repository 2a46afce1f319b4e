#include <algorithm>

#include "pruning/edits.h"

namespace frond {

void color_barks(Model& model, std::span<const Edit> edits, std::size_t colors) {
  if (std::ranges::none_of(edits, [](const Edit& edit) { return edit.bark.has_value(); })) return;
  const std::vector<std::int32_t>& parent = model.skeleton.parent;
  const std::vector<AxisNode> axes = axis_nodes(model);
  const Branching plant{parent, axes};
  const std::vector<std::int32_t> starts = axis_starts(plant);
  model.color.resize(parent.size());
  // An index goes round and round among the plant's own colours, which are no longer all.
  for (std::int32_t& color : model.color) color = static_cast<std::int32_t>(color_index(color, colors));
  auto next = static_cast<std::int32_t>(colors);
  for (const Edit& edit : edits) {
    if (!edit.bark) continue;
    const std::int32_t own = next++;
    Result<BranchPlace> place = find_place(plant, starts, edit.at);
    if (!place) continue;
    // A segment is of one colour: that of the larger part of it.
    const auto at = static_cast<std::size_t>(place->node);
    std::vector<std::uint8_t> beyond(parent.size());
    beyond[at] = 1;
    if (place->within < 0.5f) model.color[at] = own;
    for (std::size_t i = at + 1; i < parent.size(); ++i)
      if (parent[i] != Skeleton::kRoot && beyond[static_cast<std::size_t>(parent[i])])
        beyond[i] = 1, model.color[i] = own;
  }
}

}  // namespace frond
