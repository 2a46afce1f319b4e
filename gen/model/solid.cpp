#include "model/solid.h"

#include <fmt/format.h>

#include <cmath>

namespace frond {

std::uint16_t Solids::add_shape(Solid solid) {
  shapes.push_back(std::move(solid));
  return static_cast<std::uint16_t>(shapes.size() - 1);
}

void Solids::place(std::uint16_t which, Vec3 at, Quat turned, Vec3 sized) {
  shape.push_back(which);
  position.push_back(at);
  turn.push_back(turned);
  scale.push_back(sized);
}

std::string Solids::check() const {
  if (shape.size() != size() || turn.size() != size() || scale.size() != size())
    return "the arrays of the solids differ in length";
  for (const Solid& solid : shapes) {
    if (std::string fault = solid.surface.check(); !fault.empty()) return "solid: " + fault;
    if (!(solid.material.scale > 0)) return "a solid's pattern has no size";
  }
  for (std::size_t i = 0; i < size(); ++i) {
    if (shape[i] >= shapes.size()) return fmt::format("solid {} has no shape", i);
    if (!std::isfinite(glm::dot(position[i], position[i])))
      return fmt::format("solid {} is not at a finite place", i);
    if (std::abs(glm::length(turn[i]) - 1) > 1e-4f)
      return fmt::format("the turn of solid {} is not of length 1", i);
    if (!(scale[i].x > 0 && scale[i].y > 0 && scale[i].z > 0)) return fmt::format("solid {} has no size", i);
  }
  return {};
}

Surface merged(const Solids& solids) {
  Surface all;
  for (std::size_t i = 0; i < solids.size(); ++i)
    append_placed(all, solids.shapes[solids.shape[i]].surface, solids.position[i], solids.turn[i],
                  solids.scale[i]);
  all.uv.clear();
  return all;
}

}  // namespace frond
