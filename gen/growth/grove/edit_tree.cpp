#include "grove/edit_tree.h"

#include <algorithm>

#include "core/keep.h"
#include "grove/axes.h"

namespace frond {

namespace {

/// Leaves out internodes; parents, rings, scars and cuts keep their meaning.
class TreeCutter {
 public:
  TreeCutter(GrownTree& tree, const std::vector<std::uint8_t>& gone) : t_(tree), gone_(gone) {}

  void cut() {
    std::vector<std::int32_t> moved(gone_.size(), GrownTree::kRoot);
    std::int32_t next = 0;
    for (std::size_t i = 0; i < gone_.size(); ++i)
      if (!gone_[i]) moved[i] = next++;
    keep_rings();
    std::vector<std::uint8_t> stay;
    for (std::uint8_t gone : gone_) stay.push_back(!gone);
    keep(stay, t_.tip, t_.side, t_.parent, t_.radius, t_.born, t_.died, t_.fell, t_.light, t_.order, t_.leads,
         t_.axes);
    for (std::int32_t& p : t_.parent)
      if (p != GrownTree::kRoot) p = moved[p];
    std::erase_if(t_.scars, [&](const Scar& scar) { return gone_[scar.on]; });
    for (Scar& scar : t_.scars) scar.on = static_cast<std::uint32_t>(moved[scar.on]);
    std::erase_if(t_.cuts, [&](const SawnEnd& end) { return gone_[end.on]; });
    t_.regrown.clear();  // the axes tell of them now
    for (SawnEnd& end : t_.cuts) end.on = static_cast<std::uint32_t>(moved[end.on]);
  }

 private:
  void keep_rings() {
    if (t_.first_ring.empty()) return;
    std::vector<std::uint32_t> first{0};
    std::vector<float> ring;
    for (std::size_t i = 0; i < gone_.size(); ++i) {
      if (gone_[i]) continue;
      ring.insert(ring.end(), t_.ring.begin() + t_.first_ring[i], t_.ring.begin() + t_.first_ring[i + 1]);
      first.push_back(static_cast<std::uint32_t>(ring.size()));
    }
    t_.first_ring = std::move(first), t_.ring = std::move(ring);
  }

  GrownTree& t_;
  const std::vector<std::uint8_t>& gone_;
};

}  // namespace

std::vector<AxisNode> axis_nodes(const GrownTree& t) {
  if (!t.axes.empty()) return t.axes;
  return nodal_axes(
      t.parent, t.order, t.tip,
      [&](std::size_t i) { return std::ranges::binary_search(t.regrown, static_cast<std::uint32_t>(i)); },
      [&](std::size_t i) { return t.fell[i] == GrownTree::kNever; });
}

void turn_wood(GrownTree& t, std::span<const Quat> turn, std::span<const float> factor) {
  for (std::size_t i = 0; i < t.size(); ++i) {
    t.side[i] = turn[i] * t.side[i];
    t.radius[i] *= factor[i];
    for (std::uint32_t k = t.ring.empty() ? 0 : t.first_ring[i]; !t.ring.empty() && k < t.first_ring[i + 1];
         ++k)
      t.ring[k] *= factor[i];
  }
  for (Scar& scar : t.scars) {
    scar.direction = turn[scar.on] * scar.direction;
    scar.radius *= factor[scar.on], scar.girth *= factor[scar.on];
  }
}

std::vector<std::string> edit_tree(GrownTree& t, std::span<const Edit> edits) {
  Reshaped to = reshape({t.parent, t.axes}, t.tip, t.radius, edits);
  if (!to.any) return to.notes;
  t.tip = to.position;
  turn_wood(t, to.turn, to.factor);
  for (const CutEnd& end : to.ends) {
    const std::int32_t i = end.node, p = t.parent[i];
    if (p == GrownTree::kRoot) continue;
    t.tip[i] = to.end(t.parent, end);
    t.axes[i].share = glm::mix(t.axes[i].number == 0 ? t.axes[p].share : 0, t.axes[i].share, end.within);
    t.leads[i] = false;
    t.died[i] = std::min(t.died[i], t.born[i]);  // it bears no leaves
    t.cuts.push_back({static_cast<std::uint32_t>(i), SawnEnd::kFresh});
  }
  TreeCutter(t, to.gone).cut();
  return to.notes;
}

}  // namespace frond
