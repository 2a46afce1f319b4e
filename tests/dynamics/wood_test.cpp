#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "dynamics/plots.h"

namespace frond {
namespace {

/// A clearing of a hectare over 300 years, with all species.
const StandHistory& wood() {
  static const StandHistory kWood = [] {
    StandOptions options;
    options.area = {100, 100}, options.years = 300;
    options.species.assign(tree_species().begin(), tree_species().end());
    return simulate_stand(options, level_land(), Seed{1});
  }();
  return kWood;
}

double share(double year, std::initializer_list<TreeName> names) {
  StandFigures f = figures_at(wood(), year);
  double sum = 0;
  for (TreeName name : names) sum += f.basal_area[static_cast<std::size_t>(name)];
  return sum / std::accumulate(f.basal_area.begin(), f.basal_area.end(), 0.0);
}

/// Pioneers give way to what bears shade within one and a half centuries (Leuschner and Ellenberg 2017).
void expect_succession() {
  auto pioneers = [](double year) {
    return share(year, {TreeName::birch, TreeName::aspen, TreeName::rowan});
  };
  EXPECT_GT(pioneers(30), 0.5);
  EXPECT_LT(pioneers(150), 0.2);
  EXPECT_GT(share(200, {TreeName::beech, TreeName::spruce, TreeName::fir}), 0.5);
}

/// de Liocourt 1898: each class of 5 cm has 1.2 to 2 times the trees of the next one; over all classes up to
/// 60 cm, as a mean by least squares of the logarithms.
void expect_many_thin_trees() {
  std::vector<double> classes(12);
  for (int year : {220, 240, 260, 280, 300}) {
    StandFigures f = figures_at(wood(), year);
    for (std::size_t i = 0; i < std::min(classes.size(), f.diameters.size()); ++i)
      classes[i] += f.diameters[i];
  }
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    ASSERT_GT(classes[i], 0);
    double a = static_cast<double>(i), b = std::log(classes[i]);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  double q = std::exp(-(n * xy - x * y) / (n * xx - x * x));
  EXPECT_GT(q, 1.2);
  EXPECT_LT(q, 2);
}

/// Gaps of old woods: most are small, few large ones have much of the area (Kenderes et al. 2008, Drössler
/// and von Lüpke 2005: medians of 40 to 120 m2 and 3 to 16 % of the land, in beech).
void expect_small_gaps() {
  std::vector<double> gaps;
  double area = 0;
  for (int year : {200, 225, 250, 275, 300})
    for (double gap : gaps_at(wood(), year)) gaps.push_back(gap), area += gap;
  std::ranges::sort(gaps, std::greater());
  ASSERT_GT(gaps.size(), 20u);
  double median = gaps[gaps.size() / 2];
  EXPECT_LT(median, 200);
  EXPECT_GT(gaps.front(), 4 * median);
  EXPECT_GT(area / 5 / 1e4, 0.02);
  EXPECT_LT(area / 5 / 1e4, 0.3);
  double largest =
      std::accumulate(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 5), 0.0);
  EXPECT_GT(largest / area, 0.4) << "the largest fifth";
}

/// Spruces come up on rotting logs (Bače et al. 2012); beeches stand on the line of one by chance.
void expect_spruces_on_logs() {
  auto on_logs = [](TreeName name) {
    int count = 0, near = 0;
    const StandHistory& history = wood();
    for (const TreeLife& life : history.lives) {
      float year = history.sizes[life.first + 1].year;  // in which it came to breast height
      if (history.species[life.species].name != name || year < 60) continue;
      ++count;
      for (std::uint32_t i = 0; i < history.lives.size(); ++i) {
        const TreeLife& log = history.lives[i];
        TreeSize size = history.sizes[log.first + log.count - 1];
        if (log.fell > year || log.rotted < year || size.diameter < 0.15f) continue;
        float dx = life.x - log.x, dz = life.z - log.z, sine = std::sin(log.azimuth),
              cosine = std::cos(log.azimuth);
        float along = dx * sine + dz * cosine, aside = std::abs(dx * cosine - dz * sine);
        if (along < 0 || along > size.height || aside > 0.02f) continue;
        ++near;
        break;
      }
    }
    return std::pair(count, static_cast<double>(near) / std::max(count, 1));
  };
  auto [spruces, spruce_share] = on_logs(TreeName::spruce);
  auto [beeches, beech_share] = on_logs(TreeName::beech);
  ASSERT_GT(spruces, 20);
  ASSERT_GT(beeches, 100);
  EXPECT_GT(spruce_share, 2 * beech_share);
}

/// Dead trees stand, then lie, then are gone.
void expect_order_of_decay() {
  const StandHistory& history = wood();
  for (const TreeLife& life : history.lives) {
    if (life.cause == DeathCause::none) continue;
    ASSERT_LE(life.born, life.died);
    ASSERT_LE(life.died, life.fell);
    ASSERT_LE(life.fell, life.rotted);
  }
  for (const Deadwood& dead : deadwood_at(history, 250)) {
    ASSERT_GE(dead.decay, 0);
    ASSERT_LE(dead.decay, 1);
    ASSERT_EQ(dead.lies, history.lives[dead.life].fell <= 250);
  }
}

void expect_plots() {
  std::string svg = stand_svg(wood(), 200), csv = stand_csv(wood());
  EXPECT_NE(svg.find(">The stand in year 200:"), svg.npos);
  EXPECT_EQ(svg.find("nan"), svg.npos);
  EXPECT_EQ(svg.find("inf"), svg.npos);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 61);
}

/// One test, for the wood takes seconds to grow.
TEST(Wood, IsAsOldWoodsAre) {
  expect_succession();
  expect_many_thin_trees();
  expect_small_gaps();
  expect_spruces_on_logs();
  expect_order_of_decay();
  expect_plots();
}

}  // namespace
}  // namespace frond
