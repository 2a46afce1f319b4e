#include "scene/far.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/scene.h"

namespace frond {
namespace {

Scene far_scene(const std::string& scene, const std::string& organisms = "") {
  Result<Preset> preset = read_preset(R"({"film": {"frames": 1, "size": [128, 72]}, "scene": {)" + scene +
                                          R"(}, "organisms": [)" + organisms + "]}",
                                      "test.json", {});
  EXPECT_TRUE(preset) << (preset ? "" : preset.errors()[0].text());
  return *build_scene(*preset);
}

TEST(FarLandOfScenes, IsThereWhereGroundEndsInTheOpen) {
  EXPECT_TRUE(far_scene(R"("setting": "meadow", "meadow": {"blade": 0})").far);
  EXPECT_TRUE(far_scene(R"("setting": "garden", "meadow": {"blade": 0})").far);
  EXPECT_FALSE(far_scene(R"("setting": "meadow", "meadow": {"blade": 0}, "far": {"reach": 0})").far);
  EXPECT_FALSE(far_scene(R"("setting": "studio")").far);
  EXPECT_FALSE(far_scene(R"("setting": "forest")").far);
  EXPECT_TRUE(far_scene(R"("setting": "forest", "far": {})").far);
}

TEST(FarLandOfScenes, TreesAreCopiesOfTheOrganismsThatAreNamed) {
  const std::string oak = R"({"kind": "weber_penn", "name": "oak", "count": 0, "sown": {"models": 2}})";
  Scene scene = far_scene(
      R"("setting": "meadow", "meadow": {"blade": 0}, "far": {"trees": ["oak"], "woods": 0.6})", oak);
  ASSERT_EQ(scene.copy_sets.size(), 1u);
  EXPECT_GT(scene.copy_sets[0].copies.size(), 10u);
  for (const FarObject& o : scene.far->objects)
    EXPECT_TRUE(o.kind == FarKind::hedge || o.kind == FarKind::house);
  EXPECT_EQ(scene.find_fault(), "");
}

TEST(FarLandOfScenes, ViewHoldsAllThatAFilmSees) {
  Film film{.frames = 48, .size = {640, 360}};
  Camera camera;
  camera.location = Animated<Vec3>(Vec3(0, 2, 0)), camera.look_at = Animated<Vec3>(Vec3(0, 2, -10));
  FarView still = far_view(film, camera);
  EXPECT_TRUE(still.holds(Vec2(0, -100)));
  EXPECT_TRUE(still.holds(Vec2(40, -100)));
  EXPECT_FALSE(still.holds(Vec2(100, -100)));
  EXPECT_FALSE(still.holds(Vec2(0, 100)));
  EXPECT_NEAR(still.pixel, 2 * std::tan(radians(22.5)) / 640, 1e-5);
  // A turn from -z by +x to +z.
  camera.look_at = Animated<Vec3>(
      std::vector<Animated<Vec3>::Key>{{0, Vec3(0, 2, -10)}, {1, Vec3(10, 2, 0)}, {2, Vec3(0, 2, 10)}});
  FarView turn = far_view(film, camera);
  EXPECT_TRUE(turn.holds(Vec2(0, -100)));
  EXPECT_TRUE(turn.holds(Vec2(100, 0)));
  EXPECT_TRUE(turn.holds(Vec2(0, 90)));
  EXPECT_FALSE(turn.holds(Vec2(-100, 0)));
}

TEST(FarLandOfScenes, IsNoFinerForPicturesLargerThanFourThousandPixelsAcross) {
  Camera camera;
  camera.location = Animated<Vec3>(Vec3(0, 2, 0)), camera.look_at = Animated<Vec3>(Vec3(0, 2, -10));
  FarView screen = far_view({.frames = 1, .size = {3840, 2160}}, camera);
  FarView large = far_view({.frames = 1, .size = {2880, 2880}}, camera);
  FarView print = far_view({.frames = 1, .size = {16384, 16384}}, camera);
  EXPECT_DOUBLE_EQ(screen.pixels, 3840 * 2160);
  EXPECT_NEAR(print.pixels, large.pixels, 1e4);
  EXPECT_NEAR(print.pixel, large.pixel, 1e-6);
}

}  // namespace
}  // namespace frond
