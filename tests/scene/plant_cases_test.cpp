#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "core/files.h"
#include "scene/scene.h"

// Plants as people bring them from other programs.

namespace frond {
namespace {

/// The only plant of a scene of nothing else, from its grammar as JSON.
Model plant_of(const std::string& grammar, const std::string& more = "") {
  std::string text = R"({"version": 2, "scene": {"setting": "studio"}, "organisms": [{"kind": "plant",
    "place": {"at": [[0, 0]], "turn_variation": 0, "lean": 0, "size_variation": 0},
    "grammar": )" + grammar +
                     more + "}]}";
  Result<Preset> preset = read_preset(text, "tests/cases/plant.json", {});
  EXPECT_TRUE(preset) << (preset ? "" : preset.errors()[0].text());
  Result<Scene> scene = build_scene(*preset);
  EXPECT_TRUE(scene) << (scene ? "" : scene.errors()[0].text());
  return scene->specimens.at(0).model;
}

struct Measured {
  Vec3 at{0};
  float radius = 0;
};

std::vector<Measured> measured_vine() {
  std::istringstream rows(*read_file("tests/cases/07-swc-skeleton/vine.swc"));
  std::vector<Measured> nodes;
  for (std::string row; std::getline(rows, row);) {
    std::istringstream numbers(row);
    int id = 0, type = 0;
    Measured node;
    if (numbers >> id >> type >> node.at.x >> node.at.y >> node.at.z >> node.radius) nodes.push_back(node);
  }
  EXPECT_EQ(nodes.size(), 25u);
  return nodes;
}

TEST(PlantCases, AMeasuredSkeletonStandsWhereItWasMeasuredAndAsThick) {
  std::string guided = *read_file("tests/cases/07-swc-skeleton/vine.json");
  for (const std::string& grammar : {guided, std::string(R"({"file": "07-swc-skeleton/vine.swc"})")})
    for (const char* smoothing : {"1", "3"}) {
      SCOPED_TRACE(grammar.substr(0, 40) + ", smoothing " + smoothing);
      Skeleton drawn = plant_of(grammar, std::string(", \"smoothing\": ") + smoothing).skeleton;
      for (const Measured& node : measured_vine()) {
        float away = 1e9f, radius = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i)
          if (float d = glm::distance(drawn.position[i], node.at); d < away)
            away = d, radius = drawn.radius[i];
        EXPECT_LT(away, 0.02f) << node.at.x << ", " << node.at.y << ", " << node.at.z;
        EXPECT_NEAR(radius, node.radius, 0.0021f) << node.at.x << ", " << node.at.y << ", " << node.at.z;
      }
      EXPECT_NEAR(drawn.radius[0], 0.06f, 1e-5f);
      EXPECT_NEAR(drawn.position[0].y, 0, 1e-6f);
    }
}

TEST(PlantCases, AThinFirOfArbarosHasAllItsStemsAndNoneWithoutThickness) {
  std::string path = "tests/cases/08-arbaro-fir/fir.json";
  ASSERT_EQ(read_file("tests/cases/08-arbaro-fir/thin_fir.xml")->substr(0, 3), "\xef\xbb\xbf");
  Result<Preset> preset = read_preset(*read_file(path), path, {});
  ASSERT_TRUE(preset) << preset.errors()[0].text();
  Result<Scene> scene = build_scene(*preset);
  ASSERT_TRUE(scene) << scene.errors()[0].text();
  const Skeleton& fir = scene->specimens.at(0).model.skeleton;
  std::array<int, 4> stems{};
  float thinnest = 1;
  for (std::size_t i = 0; i < fir.size(); ++i) {
    thinnest = std::min(thinnest, fir.radius[i]);
    bool begins = fir.parent[i] == Skeleton::kRoot || fir.parent[i] != static_cast<std::int32_t>(i) - 1;
    if (begins) ++stems[std::min<std::size_t>(fir.order[i], 3)];
  }
  EXPECT_EQ(stems[0], 1);
  EXPECT_NEAR(stems[1], 70, 3);
  EXPECT_GT(stems[2], 900) << "short ones have fewer";
  EXPECT_LE(stems[2], 73 * 24);
  EXPECT_GT(thinnest, 1e-4f);
  printf("%d, %d, %d and %d stems, the thinnest %g m thick\n", stems[0], stems[1], stems[2], stems[3],
         static_cast<double>(2 * thinnest));
}

TEST(PlantCases, APlantWithoutPlacesStandsInTheGround) {
  Model cane = plant_of(R"g({"axiom": "F(2)", "steps": 0, "width": 0.1, "rules": []})g");
  EXPECT_NEAR(cane.skeleton.position[0].y, -0.05f, 1e-6f);
}

}  // namespace
}  // namespace frond
