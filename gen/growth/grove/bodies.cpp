#include "grove/bodies.h"

#include <cassert>

#include "core/bounds.h"
#include "core/triangle.h"

namespace frond {

namespace {

constexpr int kFineness = 4;            // cells of a body along the side of a voxel
constexpr double kMostCells = 1 << 22;  // coarser where a body is larger
constexpr float kRoof = 1.5f;           // diffuse shade under a wide roof
constexpr float kFace = 0.25f;          // what each square of a wall's face must add a layer to keep it there
constexpr float kWall = 0.7f;           // shade of a tall wall beside its foot: half of the sky
constexpr std::uint8_t kFullCell = 1, kOpenCell = 2;

/// The cells of a box, one beyond the body on each side.
struct Cells {
  float side;
  Vec3 low;
  glm::ivec3 size;
  std::vector<std::uint8_t> state;

  std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(y) * size.z + z) * size.x + x;
  }
  Vec3 middle(int x, int y, int z) const { return low + side * (Vec3(x, y, z) + 0.5f); }
};

Cells cells_round(const Surface& body, double voxel) {
  assert(!body.position.empty() && voxel > 0);
  Bounds box = bounds_of(body.position);
  double side = voxel / kFineness;
  auto count = [&] {
    glm::dvec3 n = glm::dvec3(box.size()) / side + 3.0;
    return n.x * n.y * n.z;
  };
  while (count() > kMostCells) side *= 2;
  Cells cells;
  cells.side = static_cast<float>(side);
  cells.low = box.low - cells.side;
  cells.size = glm::ivec3(glm::floor((box.high - cells.low) / cells.side)) + 2;
  cells.state.assign(cells.at(0, cells.size.y, 0), 0);
  return cells;
}

/// Fills the cells that a triangle passes through.
void fill(Cells& cells, Vec3 a, Vec3 b, Vec3 c) {
  over_triangle(a, b, c, cells.side / 2, [&](Vec3 at) {
    auto cell = glm::ivec3(glm::floor((at - cells.low) / cells.side));
    assert(glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) && glm::all(glm::lessThan(cell, cells.size)));
    cells.state[cells.at(cell.x, cell.y, cell.z)] = kFullCell;
  });
}

/// Marks what can be reached from outside; the rest is full.
void fill_inside(Cells& cells) {
  std::vector<glm::ivec3> open{{0, 0, 0}};
  cells.state[0] = kOpenCell;
  while (!open.empty()) {
    glm::ivec3 p = open.back();
    open.pop_back();
    for (int k = 0; k < 6; ++k) {
      glm::ivec3 q = p;
      q[k / 2] += k % 2 ? 1 : -1;
      if (q[k / 2] < 0 || q[k / 2] >= cells.size[k / 2]) continue;
      std::uint8_t& state = cells.state[cells.at(q.x, q.y, q.z)];
      if (state != 0) continue;
      state = kOpenCell;
      open.push_back(q);
    }
  }
}

/// What each square of the surface casts, of the side of a voxel.
struct Faces {
  float up, aside;
};

Faces faces_of(const LightLaw& law) {
  if (law.fading == Fading::diffuse) return {kRoof, kFace};
  // A wall that is endless in height and length: of each layer above, a row as wide as the pyramid.
  double sum = 0;
  for (int q = 1; q <= law.depth; ++q) sum += (2.0 * q + 1) * fading_weight(law, q);
  auto each = static_cast<float>(kWall / sum);
  return {each, each / 2};
}

}  // namespace

std::vector<Shade> shades_of_body(const Surface& body, const LightLaw& law) {
  std::vector<Shade> list;
  if (body.triangle.empty()) return list;
  Cells cells = cells_round(body, law.voxel);
  assert(cells.state[0] == 0 && "the outermost cells are open");
  for (auto [a, b, c] : body.triangle) fill(cells, body.position[a], body.position[b], body.position[c]);
  fill_inside(cells);

  Faces faces = faces_of(law);
  float squares = cells.side * cells.side / static_cast<float>(law.voxel * law.voxel);
  auto open = [&](int x, int y, int z) { return cells.state[cells.at(x, y, z)] == kOpenCell; };
  for (int y = 1; y + 1 < cells.size.y; ++y) {
    for (int z = 1; z + 1 < cells.size.z; ++z) {
      for (int x = 1; x + 1 < cells.size.x; ++x) {
        if (open(x, y, z)) continue;
        int sides = open(x - 1, y, z) + open(x + 1, y, z) + open(x, y, z - 1) + open(x, y, z + 1);
        float amount = open(x, y + 1, z) ? faces.up : faces.aside * static_cast<float>(sides);
        if (amount > 0) list.push_back({cells.middle(x, y, z), amount * squares});
      }
    }
  }
  return list;
}

}  // namespace frond
