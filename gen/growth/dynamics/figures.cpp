#include "dynamics/figures.h"

#include <algorithm>

#include "dynamics/trees.h"

namespace frond {

namespace {

constexpr double kGapCell = 2;  // metres

/// Flat areas of cells that are open, joined over their sides, in cells.
std::vector<int> open_areas(const StandGrid& grid, std::vector<char>& open) {
  std::vector<int> areas;
  std::vector<std::size_t> front;
  for (std::size_t begin = 0; begin < open.size(); ++begin) {
    if (!open[begin]) continue;
    int area = 0;
    open[begin] = false, front = {begin};
    while (!front.empty()) {
      std::size_t cell = front.back();
      front.pop_back(), ++area;
      int column = static_cast<int>(cell) % grid.columns, row = static_cast<int>(cell) / grid.columns;
      auto reach = [&](int c, int r) {
        if (c < 0 || r < 0 || c >= grid.columns || r >= grid.rows || !open[grid.index(c, r)]) return;
        open[grid.index(c, r)] = false, front.push_back(grid.index(c, r));
      };
      reach(column - 1, row), reach(column + 1, row), reach(column, row - 1), reach(column, row + 1);
    }
    areas.push_back(area);
  }
  return areas;
}

}  // namespace

std::vector<double> gaps_at(const StandHistory& history, double year) {
  StandGrid grid = grid_of(history.area, kGapCell);
  std::vector<TreeSize> sizes;
  std::vector<float> heights;
  std::vector<std::uint32_t> living = living_at(history, year);
  for (std::uint32_t i : living) {
    sizes.push_back(size_at(history, i, year));
    if (sizes.back().diameter > 0.1f) heights.push_back(sizes.back().height);
  }
  std::ranges::sort(heights);
  float high = heights.empty() ? 0 : heights[heights.size() * 95 / 100] / 2;
  std::vector<char> open(grid.size(), true);
  for (std::size_t n = 0; n < living.size(); ++n) {
    if (sizes[n].height < std::max(high, 3.0f)) continue;
    const TreeLife& life = history.lives[living[n]];
    auto x = static_cast<double>(life.x), z = static_cast<double>(life.z),
         radius = static_cast<double>(sizes[n].crown_radius);
    for (int row = grid.row(z - radius); row <= grid.row(z + radius); ++row)
      for (int column = grid.column(x - radius); column <= grid.column(x + radius); ++column) {
        double dx = grid.low_x + (column + 0.5) * kGapCell - x, dz = grid.low_z + (row + 0.5) * kGapCell - z;
        if (dx * dx + dz * dz <= radius * radius) open[grid.index(column, row)] = false;
      }
  }
  std::vector<double> gaps;
  for (int cells : open_areas(grid, open))
    if (cells > 1) gaps.push_back(cells * kGapCell * kGapCell);
  std::ranges::sort(gaps, std::greater());
  return gaps;
}

StandFigures figures_at(const StandHistory& history, double year) {
  StandFigures figures;
  double hectares = static_cast<double>(history.area.x * history.area.y) / 1e4;
  figures.basal_area.assign(history.species.size(), 0);
  int count = 0;
  auto add = [](std::vector<int>& classes, double at) {
    auto c = static_cast<std::size_t>(std::max(at, 0.0));
    if (classes.size() <= c) classes.resize(c + 1);
    ++classes[c];
  };
  for (std::uint32_t i : living_at(history, year)) {
    const TreeLife& life = history.lives[i];
    TreeSize size = size_at(history, i, year);
    auto diameter = static_cast<double>(size.diameter);
    if (size.height < 1.3f) continue;
    ++count;
    figures.mean_mass += stem_mass(history.species[life.species], size);
    figures.basal_area[life.species] += kPi / 4 * diameter * diameter / hectares;
    add(figures.diameters, diameter / 0.05);
    add(figures.ages, (year - static_cast<double>(life.born)) / 10);
  }
  figures.density = count / hectares;
  figures.mean_mass /= std::max(count, 1);
  figures.gaps = gaps_at(history, year);
  return figures;
}

}  // namespace frond
