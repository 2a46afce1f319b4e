#include "film/soft_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "draw/ambience.h"
#include "draw/eyes.h"
#include "scene/copies.h"

namespace frond {
namespace {

/// Whether the soft light of a coral that moves so is another in each frame.
bool changes(const std::string& motion) {
  Scene scene = *build_scene(*read_preset(
      R"({"film": {"frames": 24}, "scene": {"camera": {"location": [0, 0.6, 3], "look_at": [0, 0.4, 0]}},
          "organisms": [{"kind": "coral", "steps": 3, "height": 0.6, "place": {"at": [[0, 0]]}, )" +
          motion + "}]}",
      "light.json", {}));
  return light_changes(scene, nearest_pixels(scene));
}

TEST(SoftLight, IsThatOfEachFrameWhereBranchesWouldLeaveIt) {
  EXPECT_FALSE(changes(R"("wave": {"amplitude": 2})"));
  EXPECT_TRUE(changes(R"("wave": {"amplitude": 40})"));
  EXPECT_FALSE(changes(R"("food": {"strength": 60, "position": [1, 0.5, 0]})")) << "the food stays";
  std::string moving = R"("position": [[0, [1, 0.5, 0]], [1, [-1, 0.5, 0]]]})";
  EXPECT_TRUE(changes(R"("food": {"strength": 60, )" + moving));
  EXPECT_TRUE(changes(R"("food": {"stretch": 2, )" + moving));
}

/// Copies of a straight trunk 24 m high and 0.3 m thick, 1 m and 25 m from the camera.
Scene trunks() {
  return *build_scene(*read_preset(
      R"json({"film": {"frames": 1, "size": [1280, 720], "quality": "good"},
              "scene": {"setting": "meadow", "meadow": {"blade": 0}, "floor": {"relief": 0},
                        "camera": {"location": [0, 1.6, 0], "look_at": [0, 1.6, -5], "angle": 90}},
              "organisms": [{"kind": "plant", "height": 24, "count": 2, "sown": {"models": 1},
                             "place": {"at": [[-0.5, -1], [3, -25]], "size_variation": 0, "lean": 0},
                             "grammar": {"axiom": "F(1)F(1)F(1)F(1)F(1)F(1)F(1)F(1)F(1)F(1)F(1)F(1)",
                                         "width": 0.15}}]})json",
      "trunks.json", {}));
}

/// The surfels of their only model, finer where the camera needs it.
std::vector<Surfel> surfels_of_trunk(const Scene& scene) {
  const CopySet& set = scene.copy_sets.at(0);
  Model model = *grow_copy(set.organism, set.copies.model.at(0));
  std::vector<Surfel> surfels = surfels_of(set.appearance.look, model);
  refine(surfels, wanted_halvings(scene, 0, set.copies.model.at(0), surfels), set.appearance.look, model);
  return surfels;
}

TEST(SoftLight, FinerSurfelsHaveTheAreaOfTheirPartOfTheBranches) {
  double area = 0, low = 1e9, high = -1e9;
  for (const Surfel& surfel : surfels_of_trunk(trunks())) {
    EXPECT_TRUE(surfel.at.y < 12 || surfel.halvings == 0) << "out of view";
    for (const Surfel& finer : surfel.finer) {
      area += finer.area;
      low = std::min<double>(low, finer.at.y);
      high = std::max<double>(high, finer.at.y);
    }
  }
  EXPECT_GT(high - low, 2);
  EXPECT_NEAR(area / (high - low), 6.2832 * 0.15, 0.03) << "of a cylinder";
}

TEST(SoftLight, ReachesAllOfACopyNextToTheCamera) {
  Scene scene = trunks();
  std::vector<std::vector<std::vector<Surfel>>> surfels(1);
  surfels[0].resize(scene.copy_sets.at(0).copies.model.at(0) + 1u, surfels_of_trunk(scene));
  PovSpace space;
  std::istringstream text(*soft_light_text(space, scene, surfels, 0, false));
  std::vector<std::pair<Vec3, float>> probes;  // and how far each serves
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string kind, direction;
    Vec3 at, light;
    float reach = 0;
    words >> kind >> at.x >> at.y >> at.z >> direction >> light.x >> light.y >> light.z >> reach;
    auto unit = static_cast<float>(space.unit);
    probes.emplace_back(Vec3(at.x, at.y, -at.z) / unit, reach * static_cast<float>(kLightErrorBound) / unit);
  }
  for (float y = 1.2f; y < 2; y += 0.05f)
    for (float turn = 0; turn < 3.1f; turn += 0.3f) {
      Vec3 at(-0.5f + 0.15f * std::cos(turn), y, -1 + 0.15f * std::sin(turn));
      EXPECT_TRUE(std::ranges::any_of(
          probes, [&](const auto& one) { return glm::distance(one.first, at) < one.second; }))
          << at.x << ' ' << at.y << ' ' << at.z;
    }
}

}  // namespace
}  // namespace frond
