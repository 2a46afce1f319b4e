#include "pruning/keep_blades.h"

#include "core/keep.h"

namespace frond {

void keep_blades(Blades& b, const std::vector<std::uint8_t>& stay) {
  if (b.size() == 0) return;
  std::vector<std::uint8_t> stay_point(b.surface.position.size());
  std::vector<std::uint32_t> first{0}, point(stay_point.size());
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (std::uint32_t v = b.first[i]; v < b.first[i + 1]; ++v) stay_point[v] = stay[i];
    if (stay[i]) first.push_back(first.back() + b.first[i + 1] - b.first[i]);
  }
  std::uint32_t next = 0;
  for (std::size_t v = 0; v < point.size(); ++v) {
    point[v] = next;
    next += stay_point[v];
  }
  std::erase_if(b.surface.triangle, [&](const auto& t) { return !stay_point[t[0]]; });
  for (auto& triangle : b.surface.triangle)
    for (auto& corner : triangle) corner = point[corner];
  keep(stay_point, b.surface.position, b.surface.normal, b.surface.uv);
  keep(stay, b.node, b.birth, b.color, b.id, b.foot);
  b.first = std::move(first);
}

}  // namespace frond
