#include "organisms/tree/shape_tree.h"

namespace frond {

void shape_tree(GrownTree& t, const BranchesAlong& by) {
  if (by.even()) return;
  const ShapedAlong to = shape_along(t.parent, t.axes, t.tip, t.radius, by);
  t.tip = to.position;
  for (std::size_t i = 0; i < t.size(); ++i) {
    t.side[i] = to.turn[i] * t.side[i];
    t.radius[i] *= to.radius[i];
    for (std::uint32_t k = t.ring.empty() ? 0 : t.first_ring[i]; !t.ring.empty() && k < t.first_ring[i + 1];
         ++k)
      t.ring[k] *= to.radius[i];
  }
  for (Scar& scar : t.scars) {
    scar.direction = to.turn[scar.on] * scar.direction;
    scar.radius *= to.radius[scar.on], scar.girth *= to.radius[scar.on];
  }
}

}  // namespace frond
