#include "scene/sowing.h"

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "scene/scene.h"
#include "settings/forest.h"

namespace frond {
namespace {

Result<Preset> read_sown(const std::string& setting, const std::string& organisms,
                         const std::string& scene = "") {
  return read_preset(R"({"film": {"frames": 1}, "scene": {"setting": ")" + setting + "\"" + scene +
                         R"(}, "organisms": [)" + organisms + "]}",
                     "test.json", {});
}

Scene scene_of(const std::string& setting, const std::string& organisms, const std::string& scene = "") {
  Result<Preset> preset = read_sown(setting, organisms, scene);
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  Result<Scene> built = build_scene(*preset);
  if (!built) ADD_FAILURE() << built.errors().front().text();
  return *built;
}

const std::string kHills =
    R"(, "forest": {"terrain": {"size": 120, "hills": 14, "path": {"points": [[-60, 3], [0, -4], [60, 8]]}}})";
const std::string kTrees =
    R"({"kind": "weber_penn", "name": "oak", "count": 90, "sown": {"models": 4, "where": {"radius": 2.5}}})";
const std::string kHerbs =
    R"({"kind": "vase", "name": "herb", "count": 200, "place": {"lean": 0},
        "sown": {"models": 3, "upright": 0, "where": {"layer": "herbs", "radius": 0.2}}})";

TEST(Sowing, StandsOnTheLandAndIsNotPlanted) {
  Scene scene = scene_of("forest", kTrees + "," + kHerbs, kHills);
  EXPECT_TRUE(scene.specimens.empty());
  ASSERT_EQ(scene.copy_sets.size(), 2u);
  EXPECT_EQ(scene.copy_sets[1].entry, 1u);
  const Heights& heights = scene.ground->heights();
  const Plot& plot = ground_as<ForestGround>(*scene.ground).plot();
  for (const CopySet& set : scene.copy_sets) {
    const Copies& c = set.copies;
    EXPECT_EQ(c.size(), set.entry == 0 ? 90u : 200u);
    ASSERT_EQ(c.foot.size(), c.size());
    ASSERT_EQ(c.turn.size(), c.size());
    ASSERT_EQ(c.scale.size(), c.size());
    ASSERT_EQ(c.tint.size(), c.size());
    for (std::size_t i = 0; i < c.size(); ++i) {
      double ground = heights(c.foot[i].x, c.foot[i].z);
      EXPECT_LE(c.foot[i].y, ground + 1e-4);
      EXPECT_GT(c.foot[i].y, ground - 0.15);
      EXPECT_LT(c.tint[i], kTints);
      EXPECT_LT(c.model[i], set.entry == 0 ? 4 : 3);
      EXPECT_GT(plot.path_distance({c.foot[i].x, c.foot[i].z}), 0.49);
    }
  }
  // Herbs stand across the slope, trees are plumb but for their lean.
  double slanted = 0;
  const Copies& herbs = scene.copy_sets[1].copies;
  for (std::size_t i = 0; i < herbs.size(); ++i) {
    Vec3 up = herbs.turn[i] * Vec3(0, 1, 0), foot = herbs.foot[i];
    double rise = heights(foot.x + 0.5, foot.z) - heights(foot.x - 0.5, foot.z);
    EXPECT_NEAR(-up.x / up.y, rise, 0.02);
    slanted = std::max(slanted, std::abs(rise));
  }
  EXPECT_GT(slanted, 0.15);
  for (Quat turn : scene.copy_sets[0].copies.turn)
    EXPECT_GT((turn * Vec3(0, 1, 0)).y, std::cos(radians(6.1)));
}

TEST(Sowing, WorksInEverySetting) {
  for (std::string setting : {"underwater", "studio", "meadow", "garden", "forest"}) {
    std::string herb = R"({"kind": "vase", "count": 30, "sown": {"where": {"radius": 0.05, "stem": 0.02}}})";
    Scene scene = scene_of(setting, herb, R"(, "studio": {"distance": 3}, "floor": {"stones": 10})");
    ASSERT_EQ(scene.copy_sets.size(), 1u) << setting;
    EXPECT_EQ(scene.copy_sets[0].copies.size(), 30u) << setting;
    const Heights& heights = scene.ground->heights();
    float far = 0;
    for (Vec3 foot : scene.copy_sets[0].copies.foot) {
      EXPECT_NEAR(foot.y, heights(foot.x, foot.z), 0.02) << setting;
      far = std::max({far, std::abs(foot.x), std::abs(foot.z)});
    }
    if (setting == "meadow" || setting == "garden") {
      EXPECT_GT(far, 60);
      EXPECT_LE(far, 100);
    }
  }
}

TEST(Sowing, KeepsClearOfPondPathAndWhatStands) {
  std::string herb =
      R"({"kind": "vase", "count": 900, "sown": {"where": {"radius": 0.2, "reach": 12, "clear": 0.4}}})";
  std::string vase = R"(,{"kind": "vase", "place": {"at": [[3, 9]], "spacing": 2}})";
  Scene scene = scene_of("garden", herb + vase,
                         R"(, "garden": {"pond": {"center": [-4, 0], "size": [4, 3]},
                             "path": {"points": [[-20, 6], [20, 4]], "width": 1.5}})");
  EXPECT_EQ(scene.specimens.size(), 1u);
  const Plot& plot = ground_as<Lawn>(*scene.ground).plot();
  const Copies& copies = scene.copy_sets.at(0).copies;
  EXPECT_GT(copies.size(), 500u);
  for (Vec3 foot : copies.foot) {
    Vec2 at(foot.x, foot.z);
    EXPECT_GT(plot.pond_distance(at), 0.39);
    EXPECT_GT(plot.path_distance(at), 0.39);
    EXPECT_GT(glm::distance(at, Vec2(3, 9)), 2);
  }
}

TEST(Sowing, TellsWhereRoomRanOut) {
  Scene scene = scene_of("forest", R"({"kind": "weber_penn", "name": "oak", "count": 200,
      "sown": {"where": {"radius": 6}}})",
                         kHills);
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0].substr(0, 10), "oak: only ");
  EXPECT_NE(scene.notes[0].find(" of 200 found room"), std::string::npos);
}

TEST(Sowing, SaysNothingOfTheFewThatFindNoRoom) {
  Organism organism;
  organism.count = 1000;
  Scene scene;
  note_room(scene, organism, 3, 990);
  EXPECT_TRUE(scene.notes.empty());
  note_room(scene, organism, 3, 989);
  EXPECT_EQ(scene.notes.size(), 1u);
}

TEST(Sowing, IvyCannotBeSownAndDoesNotGrowOnWhatIs) {
  Result<Preset> sown = read_sown("meadow", R"({"kind": "ivy", "sown": {"models": 2}})");
  ASSERT_FALSE(sown.ok());
  ASSERT_EQ(sown.errors().size(), 1u);
  EXPECT_NE(sown.errors()[0].text().find("/organisms/0/sown: ivy cannot be sown"), std::string::npos);
  EXPECT_FALSE(read_sown("forest", kTrees + R"(,{"kind": "ivy", "on": ["oak"]})").ok());
}

TEST(Sowing, SownTreesDoNotJoinTheGrove) {
  std::string one = R"({"kind": "tree", "years": 4, "count": 1, "place": {"at": [[50, 40]]}})";
  std::string many = R"(,{"kind": "tree", "years": 4, "count": 40, "sown": {"where": {"radius": 2}}})";
  Scene alone = scene_of("forest", one, kHills), both = scene_of("forest", one + many, kHills);
  ASSERT_EQ(both.specimens.size(), 1u);
  EXPECT_EQ(alone.specimens[0].model.skeleton.position, both.specimens[0].model.skeleton.position);
  const Heights& heights = both.ground->heights();
  EXPECT_NEAR(both.specimens[0].model.skeleton.position[0].y, heights(50, 40), 0.05);
  for (Vec3 foot : both.copy_sets.at(0).copies.foot)
    EXPECT_GT(glm::distance(Vec2(foot.x, foot.z), Vec2(50, 40)), 0.6);
}

TEST(Sowing, PlacesInAForestReachAsFarAsItsLand) {
  std::string far = R"({"kind": "vase", "place": {"at": [[110, 0]]}})";
  EXPECT_TRUE(read_sown("forest", far, kHills).ok());
  EXPECT_FALSE(read_sown("meadow", far).ok());
}

TEST(Sowing, IsTheSameAtAnyThreadCount) {
  limit_threads(1);
  Scene one = scene_of("forest", kTrees, kHills);
  limit_threads(2);
  Scene two = scene_of("forest", kTrees, kHills);
  limit_threads(0);
  EXPECT_EQ(one.ground->floor().position, two.ground->floor().position);
  EXPECT_EQ(one.copy_sets[0].copies.foot, two.copy_sets[0].copies.foot);
}

}  // namespace
}  // namespace frond
