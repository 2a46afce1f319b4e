#include <gtest/gtest.h>

#include <cmath>

#include "core/files.h"
#include "organisms/tree/tree.h"
#include "scene/preset.h"

namespace frond {
namespace {

/// Breast height diameter in cm by height in m squared, and the swings a second of the stem.
struct Measured {
  double shape, frequency;
};

Measured conifer(const std::string& name, int years) {
  std::string path = "presets/trees/" + name + ".json";
  Result<Preset> preset = read_preset(*read_file(FROND_ROOT "/" + path), path, {});
  EXPECT_TRUE(preset.ok());
  TreeParams params = grower_of<Holding<TreeParams>>(preset->organisms.at(0)).params;
  params.years = years;
  TreeSite site{&params, Vec3(0), Quat(1, 0, 0, 0), 1, Seed{3}};
  Grove grove = grow_trees({&site, 1}, false, Seed{3});
  const Size& size = grove.trees[0].sizes.back();
  Model model = tree_model(params, grove.trees[0], cycle_at({}, grove.cycles, 0), {}, Seed{3});
  const Wood& wood = params.species.wood;
  auto wind = std::make_shared<const WindField>(wind_field({}, 0, Seed{1}));
  Sway sway = sway_of(model, {wood.density, wood.stiffness, wood.leaf_mass}, wind);
  EXPECT_GT(sway.stem().damping, 0.05);
  EXPECT_LT(sway.stem().damping, 0.2);
  EXPECT_GT(sway.stem_second.rate, 1.1 * sway.stem().rate);
  return {100 * size.breast_diameter / (size.height * size.height), sway.stem().frequency()};
}

/// Moore and Maguire (2004), Natural sway frequencies and damping ratios of trees: over 602 conifers of eight
/// species f = 0.0948 + 3.4317 DBH / H^2, in Hz, cm and m.
TEST(TreeSway, ConifersSwingAsFastAsMeasuredOnes) {
  std::vector<Measured> trees;
  for (const char* name : {"spruce", "pine"})
    for (int years : {18, 24, 30, 40, 50}) trees.push_back(conifer(name, years));
  double n = static_cast<double>(trees.size()), x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (auto [shape, frequency] : trees) {
    x += shape / n, y += frequency / n;
    xx += shape * shape / n, xy += shape * frequency / n, yy += frequency * frequency / n;
  }
  double slope = (xy - x * y) / (xx - x * x), r2 = slope * (xy - x * y) / (yy - y * y);
  EXPECT_NEAR(slope, 3.4317, 0.15 * 3.4317);
  EXPECT_NEAR(y, 0.0948 + 3.4317 * x, 0.1 * y);
  EXPECT_GT(r2, 0.9);
}

}  // namespace
}  // namespace frond
