#include "dynamics/trees.h"

#include <algorithm>

namespace frond {

StandGrid grid_of(Vec2 area, double cell) {
  auto count = [&](float side) {
    return std::max(static_cast<int>(std::ceil(static_cast<double>(side) / cell)), 1);
  };
  StandGrid grid{.columns = count(area.x), .rows = count(area.y), .cell = cell};
  grid.low_x = -grid.columns * cell / 2, grid.low_z = -grid.rows * cell / 2;
  return grid;
}

TreeRows::TreeRows(std::span<const StandTree> trees, const StandGrid& grid)
    : first_(static_cast<std::size_t>(grid.rows) + 1), tree_(trees.size()) {
  auto row = [&](const StandTree& tree) { return static_cast<std::size_t>(grid.row(tree.z)); };
  for (const StandTree& tree : trees) ++first_[row(tree) + 1];
  for (std::size_t r = 1; r < first_.size(); ++r) first_[r] += first_[r - 1];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < trees.size(); ++i) tree_[next[row(trees[i])]++] = i;
}

std::span<const std::uint32_t> TreeRows::in(int from, int to) const {
  int rows = static_cast<int>(first_.size()) - 1;
  std::uint32_t begin = first_[static_cast<std::size_t>(std::clamp(from, 0, rows))];
  std::uint32_t end = first_[static_cast<std::size_t>(std::clamp(to + 1, 0, rows))];
  return std::span(tree_).subspan(begin, end > begin ? end - begin : 0);
}

double stem_mass(const TreeSpecies& species, const TreeSize& size) {
  double radius = static_cast<double>(size.diameter) / 2;
  return 0.45 * kPi * radius * radius * static_cast<double>(size.height) * species.density;
}

double fresh_mass(const TreeSpecies& species, const StandTree& tree) {
  return 1.8 * stem_mass(species, {.height = static_cast<float>(tree.height),
                                   .diameter = static_cast<float>(tree.diameter)});
}

}  // namespace frond
