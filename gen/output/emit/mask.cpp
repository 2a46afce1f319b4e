#include "emit/mask.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.h"

namespace frond {

void declare_mask(std::string& text, const PovSpace& space, const Mask& mask, const std::string& name) {
  Axis axis = mask.along.value_or(Axis::y);
  Vec2 low = glm::min(mask.area[0], mask.area[1]), size = glm::max(mask.area[0], mask.area[1]) - low;
  // Pictures repeat: beyond the middles of its outer pixels it is as there.
  auto share = [&](std::string_view of, int i) {
    double half = 0.5 / (i == 0 ? mask.width : mask.height);
    return fmt::format("min({},max({},({}-({}))/{}))", number_text(1 - half, 6), number_text(half, 6), of,
                       number_text(low[i] * space.unit, 6),
                       number_text(std::max(size[i], 1e-6f) * space.unit, 6));
  };
  std::string across = share(axis == Axis::x ? "-z" : "x", 0), up = share(axis == Axis::y ? "-z" : "y", 1);
  text += fmt::format(
      "#declare {0}_Picture = function{{pigment{{image_map{{png \"{1}\" gamma 1 interpolate 2}}}}}}\n"
      "#declare {0} = function(x,y,z){{{0}_Picture({2},{3},0).red}}\n",
      name, mask.picture_name(), across, axis == Axis::y ? "1-" + up : up);
}

}  // namespace frond
