#include <array>

#include "export/surfaces.h"

namespace frond {

namespace {

/// 0 -x, 1 +x, 2 -y and so on.
std::size_t side_of(Vec3 n) {
  Vec3 a = glm::abs(n);
  int axis = a.y >= a.x && a.y >= a.z ? 1 : a.x >= a.z ? 0 : 2;
  return static_cast<std::size_t>(2 * axis + (n[axis] > 0 ? 1 : 0));
}

/// Seen from outside u is to the right and v up; on top and below v is away from z.
Vec2 laid(Vec3 p, std::size_t side) {
  const Vec2 places[] = {{p.z, p.y}, {-p.z, p.y}, {p.x, p.z}, {p.x, -p.z}, {-p.x, p.y}, {p.x, p.y}};
  return places[side];
}

}  // namespace

Surface box_mapped(const Surface& surface, std::vector<std::uint32_t>* of_vertex) {
  Surface out;
  std::vector<std::array<std::uint32_t, 6>> index(surface.position.size());
  for (auto& of : index) of.fill(UINT32_MAX);
  for (const auto& t : surface.triangle) {
    Vec3 a = surface.position[t[0]], b = surface.position[t[1]], c = surface.position[t[2]];
    std::size_t side = side_of(glm::cross(b - a, c - a));
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& at = index[t[k]][side];
      if (at == UINT32_MAX) {
        at = static_cast<std::uint32_t>(out.position.size());
        out.position.push_back(surface.position[t[k]]);
        out.normal.push_back(surface.normal[t[k]]);
        out.uv.push_back(laid(surface.position[t[k]], side));
        if (of_vertex) of_vertex->push_back(t[k]);
      }
      corners[k] = at;
    }
    out.triangle.push_back(corners);
  }
  return out;
}

void lay_picture(Surface& surface, double wide, double high, Vec2 shift) {
  Vec2 size(1 / wide, 1 / high);
  for (Vec2& at : surface.uv) at = at * size + shift;
}

}  // namespace frond
