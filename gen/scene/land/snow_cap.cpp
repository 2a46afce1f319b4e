#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/bounds.h"
#include "core/parallel.h"
#include "land/from_above.h"
#include "land/snow.h"

namespace frond {

namespace {

constexpr std::size_t kCapCells = 1'500'000;  // of a grid at most

/// The top of a body on a grid of points, and the snow there.
struct CapGrid {
  Vec2 low{0};
  float cell = 0.02f;
  glm::ivec2 size{0};
  float depth = 0.1f;                   // of the snow; it bridges steps of nearly half of that
  std::vector<float> top, share, edge;  // edge: metres to where it ends or drops

  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * size.x + column); }
  bool inside(int column, int row) const {
    return column >= 0 && row >= 0 && column < size.x && row < size.y;
  }
  bool there(int column, int row) const { return inside(column, row) && top[index(column, row)] > kBare; }
  Vec3 at(int column, int row) const {
    return {low.x + static_cast<float>(column) * cell, top[index(column, row)],
            low.y + static_cast<float>(row) * cell};
  }
  /// Height by which neighbours count as parts of one face.
  float step() const { return std::max(1.5f * cell, 0.45f * depth); }

  template <class Each>
  void each(const Each& each) const {
    for (int row = 0; row < size.y; ++row)
      for (int column = 0; column < size.x; ++column)
        if (there(column, row)) each(column, row);
  }
};

CapGrid cap_grid(const Surface& body, float depth, float cell) {
  Bounds box = bounds_of(body.position);
  Vec3 wide = box.size();
  cell = std::max(cell, std::sqrt(wide.x * wide.z / static_cast<float>(kCapCells)));
  CapGrid grid{Vec2(box.low.x, box.low.z) - cell,
               cell,
               glm::ivec2(static_cast<int>(wide.x / cell) + 3, static_cast<int>(wide.z / cell) + 3),
               depth,
               {},
               {},
               {}};
  grid.top.assign(static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y), kBare);
  for (const auto& t : body.triangle)
    rasterize(corners_of(body, t), grid.low, cell, grid.size, [&](int column, int row, float height) {
      float& top = grid.top[grid.index(column, row)];
      top = std::max(top, height);
    });
  return grid;
}

constexpr std::array<std::array<int, 2>, 8> kNeighbours{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

/// Distance to the edge, by chamfering as far as `most`.
void find_edges(CapGrid& grid, float most) {
  grid.edge.assign(grid.top.size(), most);
  grid.each([&](int column, int row) {
    float own = grid.top[grid.index(column, row)];
    for (auto [x, y] : kNeighbours)
      if (!grid.there(column + x, row + y) || grid.top[grid.index(column + x, row + y)] < own - grid.step())
        grid.edge[grid.index(column, row)] = grid.cell / 2;
  });
  auto relax = [&](int column, int row) {
    if (!grid.there(column, row)) return;
    std::size_t i = grid.index(column, row);
    for (auto [x, y] : kNeighbours) {
      if (!grid.there(column + x, row + y)) continue;
      std::size_t k = grid.index(column + x, row + y);
      if (grid.top[k] > grid.top[i] + grid.step()) continue;  // a wall is no edge of what lies at its foot
      float far = (x != 0 && y != 0 ? 1.4142f : 1.0f) * grid.cell;
      grid.edge[i] = std::min(grid.edge[i], grid.edge[k] + far);
    }
  };
  for (int row = 0; row < grid.size.y; ++row)
    for (int column = 0; column < grid.size.x; ++column) relax(column, row);
  for (int row = grid.size.y; row-- > 0;)
    for (int column = grid.size.x; column-- > 0;) relax(column, row);
}

/// Cosine of the slope at a point, over the width that snow evens out: an edge does not tilt it.
float upward(const CapGrid& grid, int column, int row) {
  int far = std::max(1, static_cast<int>(0.4f * grid.depth / grid.cell));
  float wide = static_cast<float>(far) * grid.cell, own = grid.top[grid.index(column, row)];
  auto slope = [&](int x, int y) {
    float sum = 0;
    int count = 0;
    for (int side : {-1, 1}) {
      int c = column + side * far * x, r = row + side * far * y;
      if (!grid.there(c, r)) continue;
      float rise = grid.top[grid.index(c, r)] - own;
      if (std::abs(rise) <= grid.step() + 1.5f * wide) sum += rise * static_cast<float>(side) / wide, ++count;
    }
    return count > 0 ? sum / static_cast<float>(count) : 0;
  };
  float x = slope(1, 0), z = slope(0, 1);
  return 1 / std::sqrt(1 + x * x + z * z);
}

/// Snow fills pits and rounds what is rough: its top is that of its neighbourhood.
void round_off(CapGrid& grid, float depth) {
  constexpr int kTimes = 4;
  std::vector<float> top(grid.top.size(), kBare), next;
  grid.each([&](int column, int row) {
    std::size_t i = grid.index(column, row);
    top[i] = grid.top[i] + depth * grid.share[i];
  });
  for (int time = 0; time < kTimes; ++time) {
    next = top;
    grid.each([&](int column, int row) {
      std::size_t i = grid.index(column, row);
      if (grid.edge[i] < grid.cell) return;
      float sum = 2 * top[i], weight = 2;
      for (auto [x, y] : kNeighbours)
        if (grid.there(column + x, row + y)) {
          std::size_t k = grid.index(column + x, row + y);
          if (std::abs(grid.top[k] - grid.top[i]) <= grid.step()) sum += top[k], weight += 1;
        }
      next[i] = sum / weight;
    });
    std::swap(top, next);
  }
  // Where none may lie there is none.
  grid.each([&](int column, int row) {
    std::size_t i = grid.index(column, row);
    if (grid.share[i] > 0) grid.share[i] = std::max(0.0f, (top[i] - grid.top[i]) / depth);
  });
}

/// Lets the rim of a sheet down to what it lies on.
void add_skirt(SnowSheet& sheet) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (auto [a, b, c] : sheet.triangle) sides.insert({{a, b}, {b, c}, {c, a}});
  std::map<std::uint32_t, std::uint32_t> below;
  auto foot = [&](std::uint32_t i) {
    auto [at, fresh] = below.try_emplace(i, static_cast<std::uint32_t>(sheet.bare.size()));
    if (fresh) sheet.bare.push_back(Vec3(sheet.bare[i])), sheet.share.push_back(0);
    return at->second;
  };
  for (auto [a, b] : sides) {
    if (sides.contains({b, a})) continue;
    std::uint32_t under_a = foot(a), under_b = foot(b);
    sheet.triangle.push_back({b, a, under_a});
    sheet.triangle.push_back({b, under_a, under_b});
  }
}

SnowSheet sheet_of(const CapGrid& grid) {
  SnowSheet sheet;
  std::vector<std::uint32_t> number(grid.top.size(), UINT32_MAX);
  auto corner = [&](int column, int row) {
    std::uint32_t& own = number[grid.index(column, row)];
    if (own == UINT32_MAX) {
      own = static_cast<std::uint32_t>(sheet.bare.size());
      sheet.bare.push_back(grid.at(column, row));
      sheet.share.push_back(grid.share[grid.index(column, row)]);
    }
    return own;
  };
  auto joined = [&](std::initializer_list<glm::ivec2> points) {
    float low = -kBare, high = kBare;
    bool any = false;
    for (glm::ivec2 p : points) {
      if (!grid.there(p.x, p.y)) return false;
      std::size_t i = grid.index(p.x, p.y);
      low = std::min(low, grid.top[i]), high = std::max(high, grid.top[i]);
      any = any || grid.share[i] > 0;
    }
    return any && high - low <= 2 * grid.step();
  };
  auto add = [&](glm::ivec2 a, glm::ivec2 b, glm::ivec2 c) {
    if (joined({a, b, c})) sheet.triangle.push_back({corner(a.x, a.y), corner(b.x, b.y), corner(c.x, c.y)});
  };
  for (int row = 0; row + 1 < grid.size.y; ++row)
    for (int column = 0; column + 1 < grid.size.x; ++column) {
      glm::ivec2 a(column, row), b(column + 1, row), c(column, row + 1), d(column + 1, row + 1);
      add(a, c, b);
      add(b, c, d);
    }
  add_skirt(sheet);
  return sheet;
}

}  // namespace

SnowSheet snow_on_body(const Surface& body, double depth, float cell, const OpennessAt& openness) {
  if (body.triangle.empty() || depth <= 0) return {};
  auto deep = static_cast<float>(depth);
  CapGrid grid = cap_grid(body, deep, cell);
  find_edges(grid, deep);
  grid.share.assign(grid.top.size(), 0);
  parallel_for(static_cast<std::size_t>(grid.size.y), [&](std::size_t r) {
    auto row = static_cast<int>(r);
    for (int column = 0; column < grid.size.x; ++column) {
      if (!grid.there(column, row)) continue;
      std::size_t i = grid.index(column, row);
      auto stays = static_cast<float>(lying_share(static_cast<double>(upward(grid, column, row))));
      if (stays <= 0) continue;
      float in = 1 - grid.edge[i] / deep;
      grid.share[i] = stays * openness(grid.at(column, row)) * std::sqrt(std::max(0.0f, 1 - in * in));
    }
  });
  round_off(grid, deep);
  return sheet_of(grid);
}

}  // namespace frond
