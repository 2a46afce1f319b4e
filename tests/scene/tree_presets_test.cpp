#include <gtest/gtest.h>

#include <array>

#include "core/files.h"
#include "grove/age.h"
#include "organisms/tree/tree.h"
#include "scene/preset.h"

namespace frond {
namespace {

struct Range {
  double least, most;
};

/// Metres; the diameter is that of the stem at breast height.
struct Expected {
  Range height, diameter;
};

constexpr std::array<int, 6> kAges{10, 20, 40, 60, 100, 150};

struct SpeciesSizes {
  const char* name;
  std::array<Expected, 6> at;  ///< of kAges
};

/// From trees on poor sites to those that stand free on good ones. Heights in stands: Edwards and Christie
/// (1981), Yield models for forest management. Girths in the open, about 2.5 cm a year: Mitchell (1974), A
/// field guide to the trees of Britain; White (1998), Estimating the age of large and veteran trees. Planted
/// trees of the south and of streets: McPherson, van Doorn and Peper (2016), Urban tree database. Largest
/// sizes: San-Miguel-Ayanz et al. (2016), European atlas of forest tree species.
const SpeciesSizes kSpecies[] = {
    {"oak",
     {{{{2, 6.5}, {0.02, 0.13}},
       {{5, 11.5}, {0.06, 0.3}},
       {{10, 19}, {0.15, 0.5}},
       {{13, 23}, {0.24, 0.7}},
       {{17, 29}, {0.4, 1.0}},
       {{19, 33}, {0.55, 1.35}}}}},
    {"beech",
     {{{{2, 6}, {0.02, 0.12}},
       {{5, 11}, {0.08, 0.28}},
       {{11, 19}, {0.18, 0.48}},
       {{15, 26}, {0.28, 0.68}},
       {{20, 34}, {0.45, 1.0}},
       {{22, 40}, {0.6, 1.35}}}}},
    {"birch",
     {{{{4, 9}, {0.03, 0.13}},
       {{8, 15}, {0.08, 0.26}},
       {{13, 22}, {0.17, 0.42}},
       {{16, 26}, {0.22, 0.55}},
       {{18, 30}, {0.28, 0.75}},
       {{18, 30}, {0.3, 0.85}}}}},
    {"spruce",
     {{{{2, 6}, {0.02, 0.1}},
       {{5, 12}, {0.07, 0.22}},
       {{12, 22}, {0.18, 0.42}},
       {{18, 30}, {0.25, 0.58}},
       {{24, 38}, {0.35, 0.9}},
       {{28, 45}, {0.45, 1.1}}}}},
    {"maple",
     {{{{3, 8}, {0.03, 0.14}},
       {{6, 13}, {0.1, 0.3}},
       {{10, 20}, {0.2, 0.55}},
       {{12, 25}, {0.28, 0.75}},
       {{15, 30}, {0.4, 1.0}},
       {{17, 33}, {0.5, 1.3}}}}},
    {"pine",
     {{{{2, 6}, {0.02, 0.12}},
       {{5, 11}, {0.08, 0.25}},
       {{10, 19}, {0.17, 0.45}},
       {{13, 24}, {0.24, 0.65}},
       {{18, 30}, {0.33, 0.8}},
       {{20, 34}, {0.4, 1.1}}}}},
    {"cherry",
     {{{{2.5, 6}, {0.04, 0.16}},
       {{4, 9}, {0.1, 0.32}},
       {{5, 12}, {0.2, 0.6}},
       {{6, 14}, {0.3, 0.8}},
       {{7, 16}, {0.4, 1.1}},
       {{7, 18}, {0.5, 1.4}}}}},
    {"olive",
     {{{{1.5, 4}, {0.02, 0.1}},
       {{2.5, 6}, {0.06, 0.22}},
       {{3, 8}, {0.12, 0.45}},
       {{3.5, 10}, {0.16, 0.6}},
       {{4, 12}, {0.25, 0.9}},
       {{4, 15}, {0.3, 1.2}}}}},
    {"cypress",
     {{{{3, 7.5}, {0.04, 0.14}},
       {{6, 13}, {0.1, 0.26}},
       {{10, 19}, {0.17, 0.42}},
       {{12, 24}, {0.22, 0.55}},
       {{14, 28}, {0.28, 0.75}},
       {{15, 32}, {0.3, 0.95}}}}},
    {"cedar",
     {{{{2, 6}, {0.02, 0.12}},
       {{5, 12}, {0.08, 0.3}},
       {{10, 20}, {0.22, 0.6}},
       {{13, 26}, {0.35, 0.9}},
       {{17, 32}, {0.55, 1.3}},
       {{20, 36}, {0.7, 1.75}}}}},
    {"poplar",
     {{{{6, 12}, {0.08, 0.22}},
       {{12, 21}, {0.18, 0.42}},
       {{18, 30}, {0.3, 0.75}},
       {{20, 34}, {0.4, 1.0}},
       {{22, 38}, {0.5, 1.3}},
       {{22, 38}, {0.55, 1.5}}}}},
    {"willow",
     {{{{5, 10}, {0.08, 0.25}},
       {{8, 16}, {0.2, 0.5}},
       {{10, 20}, {0.4, 0.9}},
       {{10, 22}, {0.5, 1.2}},
       {{10, 25}, {0.6, 1.6}},
       {{10, 25}, {0.6, 1.8}}}}},
    {"acacia",
     {{{{2, 6}, {0.03, 0.14}},
       {{3, 8}, {0.08, 0.28}},
       {{4, 12}, {0.15, 0.45}},
       {{5, 15}, {0.2, 0.55}},
       {{5, 18}, {0.28, 0.8}},
       {{5, 20}, {0.35, 1.0}}}}},
};

TreeParams tree_of(const std::string& name) {
  std::string path = "presets/trees/" + name + ".json";
  Result<Preset> preset = read_preset(*read_file(FROND_ROOT "/" + path), path, {});
  EXPECT_TRUE(preset.ok()) << (preset ? "" : preset.errors()[0].text());
  return grower_of<Holding<TreeParams>>(preset->organisms.at(0)).params;
}

/// What a species would cost to grow if it grew on and on as when it is young.
constexpr std::size_t kMostInternodes = 600'000;

TEST(TreePresets, TreesDoNotOutgrowTheirSpeciesAsTheyAge) {
  for (const SpeciesSizes& expected : kSpecies) {
    TreeParams params = tree_of(expected.name);
    params.years = kAges.back();
    TreeSite site{&params, Vec3(0), Quat(1, 0, 0, 0), 1, Seed{3}.child("tree")};
    GrownTree tree = grow_trees({&site, 1}, false, Seed{3}.child("weather")).trees[0];
    for (std::size_t k = 0; k < kAges.size(); ++k) {
      SCOPED_TRACE(std::string(expected.name) + " of " + std::to_string(kAges[k]) + " years");
      auto cycle = static_cast<std::size_t>(growth_cycles(params.species, kAges[k]));
      ASSERT_LE(cycle, tree.sizes.size());
      const Size& size = tree.sizes[cycle - 1];
      auto [height, diameter] = expected.at[k];
      EXPECT_GE(size.height, height.least);
      EXPECT_LE(size.height, height.most);
      EXPECT_GE(size.breast_diameter, diameter.least);
      EXPECT_LE(size.breast_diameter, diameter.most);
      EXPECT_LT(size.internodes, kMostInternodes);
    }
  }
}

/// The colours of autumn come with the season, so that another `at` gives another time of the year. A cherry
/// in blossom bears its flowers as leaves, and the larch is one in autumn.
TEST(TreePresets, LeavesAreGreenInSummer) {
  int seen = 0;
  for (const char* name : {"trees/acacia", "trees/beech", "trees/birch", "trees/cedar", "trees/cypress",
                           "trees/maple", "trees/oak", "trees/olive", "trees/pine", "trees/poplar",
                           "trees/spruce", "trees/willow", "aspen", "black_oak", "weeping_willow"}) {
    std::string path = std::string("presets/") + name + ".json";
    Result<Preset> preset = read_preset(*read_file(FROND_ROOT "/" + path), path, {});
    ASSERT_TRUE(preset) << preset.errors()[0].text();
    const Grower& grower = *preset->organisms.at(0).grower;
    std::vector<Color> colors;
    if (const Appearance appearance = grower.appearance(); appearance.look.leaves)
      colors = appearance.look.leaves->colors;
    if (const auto* tree = dynamic_cast<const Holding<TreeParams>*>(&grower); tree && colors.empty())
      colors = tree->params.leaves.colors;
    ASSERT_FALSE(colors.empty()) << name;
    for (const Color& c : colors) EXPECT_GT(c.green, c.red) << name;
    seen += grower.appearance().season.has_value();
  }
  EXPECT_EQ(seen, 2) << "aspen and maple are filmed in autumn";
}

}  // namespace
}  // namespace frond
