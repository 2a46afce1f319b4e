#include "organisms/tree/shape_tree.h"

#include "grove/edit_tree.h"

namespace frond {

void shape_tree(GrownTree& t, const BranchesAlong& by) {
  if (by.even()) return;
  const ShapedAlong to = shape_along(t.parent, t.axes, t.tip, t.radius, by);
  t.tip = to.position;
  turn_wood(t, to.turn, to.radius);
}

}  // namespace frond
