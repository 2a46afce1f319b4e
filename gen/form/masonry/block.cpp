#include "masonry/block.h"

#include <algorithm>
#include <cassert>

namespace frond {

namespace {

/// Where the lattice of a block has its lines along one axis: both ends, both inner ends of the round edges,
/// and the cuts between.
std::vector<float> lines(float size, float bevel, int parts) {
  std::vector<float> at{-size / 2};
  float inner = size / 2 - bevel;
  for (int i = 0; i <= parts; ++i)
    at.push_back(-inner + 2 * inner * static_cast<float>(i) / static_cast<float>(parts));
  at.push_back(size / 2);
  return at;
}

}  // namespace

Surface block_surface(const Block& block) {
  float least = std::min({block.size.x, block.size.y, block.size.z});
  assert(least > 0);
  float bevel = std::clamp(block.bevel, 1e-3f * least, 0.45f * least);
  std::array<std::vector<float>, 3> line;
  for (int axis = 0; axis < 3; ++axis)
    line[axis] = lines(block.size[axis], bevel, std::max(1, block.parts[axis]));
  Vec3 inner = block.size * 0.5f - bevel;

  // The points of the lattice that lie on its hull, each pulled in to the rounded box.
  std::array<std::size_t, 3> count{line[0].size(), line[1].size(), line[2].size()};
  std::vector<std::uint32_t> index(count[0] * count[1] * count[2]);
  auto key = [&](const std::array<std::size_t, 3>& at) {
    return (at[0] * count[1] + at[1]) * count[2] + at[2];
  };
  Surface surface;
  for (std::size_t i = 0; i < count[0]; ++i)
    for (std::size_t j = 0; j < count[1]; ++j)
      for (std::size_t k = 0; k < count[2]; ++k) {
        if (i > 0 && i + 1 < count[0] && j > 0 && j + 1 < count[1] && k > 0 && k + 1 < count[2]) continue;
        Vec3 p(line[0][i], line[1][j], line[2][k]), core = glm::clamp(p, -inner, inner);
        index[key({i, j, k})] = static_cast<std::uint32_t>(surface.position.size());
        surface.position.push_back(core + glm::normalize(p - core) * bevel);
      }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (std::size_t side : {std::size_t{0}, count[axis] - 1})
      for (std::size_t i = 0; i + 1 < count[u]; ++i)
        for (std::size_t j = 0; j + 1 < count[v]; ++j) {
          auto corner = [&](std::size_t a, std::size_t b) {
            std::array<std::size_t, 3> at{};
            at[axis] = side, at[u] = i + a, at[v] = j + b;
            return index[key(at)];
          };
          std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          if (side == 0) std::swap(b, d);
          add_quad(surface, a, b, c, d);
        }
  }
  set_normals(surface);
  return surface;
}

double volume(const Surface& surface) {
  double sum = 0;
  for (auto [a, b, c] : surface.triangle)
    sum += glm::dot(DVec3(surface.position[a]),
                    glm::cross(DVec3(surface.position[b]), DVec3(surface.position[c])));
  return sum / 6;
}

Color toned(const Color& color, double brightness, double warmth) {
  auto channel = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
  return {channel(color.red * brightness * (1 + warmth)), channel(color.green * brightness),
          channel(color.blue * brightness * (1 - warmth))};
}

}  // namespace frond
