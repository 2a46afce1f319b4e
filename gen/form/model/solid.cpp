#include "model/solid.h"

#include <fmt/format.h>

#include <algorithm>
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

Surface surface_at(const Solid& solid, float share) {
  Surface now = solid.surface;
  if (solid.past.empty() || share >= 1) return now;
  float at = std::max(share, 0.0f) * static_cast<float>(solid.past.size());
  auto step = std::min(static_cast<std::size_t>(at), solid.past.size() - 1);
  float t = at - static_cast<float>(step);
  auto places = [&](std::size_t k) -> const std::vector<Vec3>& {
    return k < solid.past.size() ? solid.past[k] : solid.surface.position;
  };
  // A Catmull-Rom spline through the steps.
  const auto &a = places(step > 0 ? step - 1 : 0), &b = places(step), &c = places(step + 1),
             &d = places(step + 2);
  Hermite weigh = hermite(t);
  auto from = static_cast<float>(weigh.start), slope = static_cast<float>(weigh.start_slope) / 2,
       to = static_cast<float>(weigh.end), last = static_cast<float>(weigh.end_slope) / 2;
  for (std::size_t i = 0; i < now.position.size(); ++i)
    now.position[i] = from * b[i] + to * c[i] + slope * (c[i] - a[i]) + last * (d[i] - b[i]);
  set_normals(now);
  return now;
}

Bounds bounds_of(const Solids& solids) {
  Bounds box;
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (const Vec3& at : solids.shapes[solids.shape[i]].surface.position) box.extend(solids.placed(i, at));
  return box;
}

Bounds rough_bounds_of(const Solids& solids) {
  std::vector<Bounds> shapes;
  for (const Solid& solid : solids.shapes) shapes.push_back(bounds_of(solid.surface.position));
  Bounds box;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Bounds& shape = shapes[solids.shape[i]];
    if (shape.empty()) continue;  // it has no mesh
    for (int k = 0; k < 8; ++k) box.extend(solids.placed(i, shape.corner(k)));
  }
  return box;
}

Solids grown_to(const Solids& solids, float share) {
  Solids now = solids;
  for (Solid& solid : now.shapes) {
    solid.surface = surface_at(solid, share);
    solid.past.clear();
  }
  return now;
}

std::string Solids::find_fault() const {
  if (shape.size() != size() || turn.size() != size() || scale.size() != size())
    return "the arrays of the solids differ in length";
  for (const Solid& solid : shapes) {
    if (std::string fault = solid.surface.find_fault(); !fault.empty()) return "solid: " + fault;
    if (!(solid.material.scale > 0)) return "a solid's pattern has no size";
    if (!solid.light.empty() && solid.light.size() != solid.surface.position.size())
      return "not every vertex of a solid has its light";
    for (const std::vector<Vec3>& step : solid.past)
      if (step.size() != solid.surface.position.size()) return "a solid has had more or fewer vertices";
  }
  for (std::size_t i = 0; i < size(); ++i) {
    if (shape[i] >= shapes.size()) return fmt::format("solid {} has no shape", i);
    if (!std::isfinite(glm::dot(position[i], position[i])))
      return fmt::format("solid {} is not at a finite place", i);
    if (!(std::abs(glm::length(turn[i]) - 1) <= 1e-4f))
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
