#include "dynamics/trees.h"

#include <utility>

#include "core/parallel.h"

namespace frond {

namespace {

/// What a crown has over a cell.
struct CrownColumn {
  double share = 0;   // of the cell that it covers
  double top = 0;     // metres, the crown's surface there
  double leaves = 0;  // m2 of leaves in a m3
};

/// A crown as the square of its area.
CrownColumn crown_column(const StandTree& tree, const TreeSpecies& species, const StandGrid& grid, int column,
                         int row) {
  double half = tree.crown_radius * std::sqrt(kPi) / 2;
  double x0 = grid.low_x + column * grid.cell, z0 = grid.low_z + row * grid.cell;
  double left = std::max(tree.x - half, x0), right = std::min(tree.x + half, x0 + grid.cell);
  double back = std::max(tree.z - half, z0), front = std::min(tree.z + half, z0 + grid.cell);
  if (right <= left || front <= back) return {};
  double dx = (left + right) / 2 - tree.x, dz = (back + front) / 2 - tree.z;
  double out = std::min((dx * dx + dz * dz) / (tree.crown_radius * tree.crown_radius), 0.9);
  // Half of a paraboloid's box is full.
  return {(right - left) * (front - back) / (grid.cell * grid.cell), tree.height - tree.crown_length() * out,
          species.leaf_area / (0.5 * tree.crown_length())};
}

/// Adds the leaves of all trees to the cells of a row.
void add_leaves(Canopy& canopy, std::vector<float>& leaves, const StandTree& tree, const TreeSpecies& species,
                int row) {
  const StandGrid& grid = canopy.grid;
  int last = grid.column(tree.x + tree.crown_radius);
  for (int column = grid.column(tree.x - tree.crown_radius); column <= last; ++column) {
    CrownColumn own = crown_column(tree, species, grid, column, row);
    if (own.share <= 0) continue;
    std::size_t cell = grid.index(column, row);
    if (own.share > 0.3) canopy.top[cell] = std::max(canopy.top[cell], static_cast<float>(own.top));
    for (int k = static_cast<int>(tree.crown_base / Canopy::kLayer); k * Canopy::kLayer < own.top; ++k) {
      double depth =
          std::min(own.top, (k + 1) * Canopy::kLayer) - std::max(tree.crown_base, k * Canopy::kLayer);
      leaves[static_cast<std::size_t>(k) * grid.size() + cell] +=
          static_cast<float>(own.share * own.leaves * depth);
    }
  }
}

/// Light below a row of cells of a layer. A share comes from the cells beside, for the mean ray comes down at
/// about 35 degrees from the vertical; beyond the land it is as bright as at its rim.
void shine(Canopy& canopy, const std::vector<float>& leaves, int layer, int row) {
  const StandGrid& grid = canopy.grid;
  const auto aside =
      static_cast<float>(std::min(0.5 * Canopy::kLayer * Canopy::kLayer / (4 * grid.cell * grid.cell), 0.2));
  std::size_t here = static_cast<std::size_t>(layer) * grid.size(), above = here + grid.size();
  auto at = [&](int column, int r) {
    return canopy
        .light[above + grid.index(std::clamp(column, 0, grid.columns - 1), std::clamp(r, 0, grid.rows - 1))];
  };
  for (int c = 0; c < grid.columns; ++c) {
    float sides = at(c - 1, row) + at(c + 1, row) + at(c, row - 1) + at(c, row + 1);
    float light = (1 - 4 * aside) * at(c, row) + aside * sides;
    std::size_t cell = here + grid.index(c, row);
    canopy.light[cell] = light * std::exp(-static_cast<float>(kExtinction) * leaves[cell]);
  }
}

/// Light of 0..1 on a crown, its own shade left out.
struct CrownLight {
  double top = 1;   ///< on its top
  double mean = 1;  ///< on all of it: its top and its sides at two heights
};

CrownLight light_on(const Canopy& canopy, const StandTree& tree, const TreeSpecies& species) {
  const StandGrid& grid = canopy.grid;
  auto at = [&](double dx, double dz, double height) {
    int column = grid.column(tree.x + dx), row = grid.row(tree.z + dz);
    double level = (std::floor(height / Canopy::kLayer) + 1) * Canopy::kLayer;
    CrownColumn own = crown_column(tree, species, grid, column, row);
    double shade = own.share * own.leaves * std::max(own.top - level, 0.0);
    return std::min(canopy.light_above(grid.index(column, row), height) * std::exp(kExtinction * shade), 1.0);
  };
  auto round = [&](double out, double down) {
    double height = tree.height - down * tree.crown_length(), far = out * tree.crown_radius;
    return (at(-far, 0, height) + at(far, 0, height) + at(0, -far, height) + at(0, far, height)) / 4;
  };
  double top = at(0, 0, tree.height);
  return {top, 0.2 * top + 0.4 * round(0.7, 0.5) + 0.4 * round(0.9, 0.8)};
}

constexpr double kOpenCrown = 0.85;   // share of the height that is crown in the open
constexpr double kLeastCrown = 0.15;  // the same of the most crowded tree
constexpr double kSlender = 110;      // height over diameter from which height lags, up to 140

/// cm of girth that a tree in the open adds, as metres of diameter: less as a sapling, and as it comes to its
/// greatest diameter.
double open_gain(const TreeSpecies& species, double diameter) {
  double full = diameter / species.diameter;
  return species.girth_gain / (100 * kPi) * (diameter + 0.01) / (diameter + 0.02) *
         std::max(1 - full * full, 0.0);
}

void raise_crown(StandTree& tree, const TreeSpecies& species, const Canopy& canopy) {
  const StandGrid& grid = canopy.grid;
  // The light among the lowest branches, in the tree's own shade.
  double out = 0.7 * tree.crown_radius, light = 0;
  for (auto [dx, dz] : {std::pair(-out, 0.0), {out, 0.0}, {0.0, -out}, {0.0, out}})
    light += canopy.light_above(grid.at(tree.x + dx, tree.z + dz), tree.crown_base) / 4;
  double needed = 0.9 * std::exp(-kExtinction * species.leaf_area);
  double rise = light < needed ? 0.6 * (1 - light / needed) : 0;
  double least = (1 - kOpenCrown) * tree.height, most = (1 - kLeastCrown) * tree.height;
  tree.crown_base = std::clamp(std::max(tree.crown_base + rise, least), 0.0, most);
}

}  // namespace

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

Canopy canopy_of(std::span<const StandTree> trees, std::span<const TreeSpecies> species,
                 const StandGrid& grid) {
  double highest = 0, widest = 0;
  for (const StandTree& tree : trees)
    highest = std::max(highest, tree.height), widest = std::max(widest, tree.crown_radius);
  Canopy canopy{.grid = grid, .layers = static_cast<int>(highest / Canopy::kLayer) + 1};
  auto layers = static_cast<std::size_t>(canopy.layers);
  canopy.top.assign(grid.size(), 0);
  canopy.light.assign((layers + 1) * grid.size(), 1);
  std::vector<float> leaves(layers * grid.size());
  TreeRows rows(trees, grid);
  int near = static_cast<int>(widest / grid.cell) + 1;
  auto count = static_cast<std::size_t>(grid.rows);
  parallel_for(count, [&](std::size_t r) {
    int row = static_cast<int>(r);
    for (std::uint32_t i : rows.in(row - near, row + near))
      add_leaves(canopy, leaves, trees[i], species[trees[i].species], row);
  });
  for (int layer = canopy.layers - 1; layer >= 0; --layer) {
    auto shine_row = [&](std::size_t r) { shine(canopy, leaves, layer, static_cast<int>(r)); };
    // To wake threads for a small layer takes longer than the layer.
    if (grid.size() < 20'000)
      for (std::size_t r = 0; r < count; ++r) shine_row(r);
    else
      parallel_for(count, shine_row);
  }
  return canopy;
}

double light_response(const TreeSpecies& species, double light) {
  double tolerance = std::clamp((species.tolerance - 1) / 4, 0.0, 1.0);
  double bears = 1 - std::exp(-4.64 * (light - 0.03)), needs = 2.24 * (1 - std::exp(-1.136 * (light - 0.08)));
  return std::clamp(needs + (bears - needs) * tolerance, 0.0, 1.0);
}

double site_response(const TreeSpecies& species, double temperature, double moisture) {
  double warm = std::clamp((temperature - species.coldest) / 4, 0.0, 1.0);
  double off = (moisture - species.moisture) / species.moisture_span;
  return std::sqrt(warm) * std::exp(-0.5 * off * off);
}

double crown_radius_at(const TreeSpecies& species, double diameter) {
  return species.crown_foot + species.crown_gain * diameter;
}

void grow_year(StandTree& tree, const TreeSpecies& species, const Canopy& canopy) {
  CrownLight light = light_on(canopy, tree, species);
  double bright = light_response(species, light.top),
         crown = tree.crown_length() / (kOpenCrown * tree.height);
  double gain = bright * std::min(light.mean / light.top, 1.0) * std::sqrt(std::min(crown, 1.0)) * tree.site;
  tree.vigour += 0.3 * (gain - tree.vigour);

  // Poor places have lower trees: the curve of heights is lower there.
  double lower = 0.2 + 0.8 * tree.site, height = tree.height / lower;
  double rise = (height_at(species, age_at(species, height) + 0.5 + 0.5 * tree.talent) - height) * lower;
  double slender = std::clamp((kSlender + 30 - tree.height / tree.diameter) / 30, 0.0, 1.0);
  if (height < species.height) tree.height += std::max(rise, 0.0) * std::min(1.5 * bright, 1.0) * slender;
  tree.diameter += open_gain(species, tree.diameter) * gain * tree.talent;
  tree.crown_radius = crown_radius_at(species, tree.diameter);
  raise_crown(tree, species, canopy);
}

}  // namespace frond
