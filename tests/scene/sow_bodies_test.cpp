#include <gtest/gtest.h>

#include "core/parallel.h"
#include "creeping/triangle_surface.h"
#include "scene/scene.h"

namespace frond {
namespace {

/// A preset with a boulder, and what is to be sown on it.
Result<Scene> on_boulder(const std::string& sown) {
  Result<Preset> preset = read_preset(
      R"({"film": {"frames": 1}, "scene": {"setting": "meadow"}, "organisms": [
          {"kind": "rock", "name": "boulder", "size": 2, "place": {"at": [[0, 0]]}}, )" +
          sown + "]}",
      "test.json", {});
  if (!preset) return preset.errors();
  return build_scene(*preset);
}

std::string tufts(int count, const std::string& where) {
  return R"({"kind": "vase", "name": "tuft", "count": )" + std::to_string(count) +
         R"(, "place": {"on": ["boulder"], "lean": 0, "size_variation": 0},
             "sown": {"models": 2, "upright": 0, "where": {"radius": 0.06, "stem": 0)" +
         where + "}}}";
}

TriangleSurface skin(const Scene& scene) {
  for (const Specimen& s : scene.specimens)
    if (s.name == "boulder") return std::move(*TriangleSurface::build(skin_of(s.model)));
  throw std::runtime_error("there is no boulder");
}

TEST(SowBodies, StandOnTheSurfaceAndKeepApart) {
  Result<Scene> scene = on_boulder(tufts(150, R"(, "slope": 90)"));
  ASSERT_TRUE(scene.ok()) << scene.errors()[0].text();
  ASSERT_EQ(scene->copy_sets.size(), 1u);
  const Copies& copies = scene->copy_sets[0].copies;
  EXPECT_EQ(copies.size(), 150u);
  EXPECT_EQ(scene->find_fault(), "");
  TriangleSurface host = skin(*scene);
  for (std::size_t i = 0; i < copies.size(); ++i) {
    std::optional<Contact> near = host.closest(DVec3(copies.foot[i]));
    ASSERT_TRUE(near);
    EXPECT_LT(near->distance, 1e-3);
    // Without `upright` they stand at right angles to it.
    Vec3 up = copies.turn[i] * Vec3(0, 1, 0);
    EXPECT_NEAR(glm::dot(up, Vec3(host.face_normal(near->triangle))), 1, 0.02);
    for (std::size_t k = 0; k < i; ++k) EXPECT_GE(glm::distance(copies.foot[i], copies.foot[k]), 0.1199f);
  }
}

TEST(SowBodies, KeepToTheirSlopes) {
  auto steepest = [](const std::string& slope) {
    Result<Scene> scene = on_boulder(tufts(120, R"(, "slope": )" + slope));
    EXPECT_TRUE(scene.ok());
    TriangleSurface host = skin(*scene);
    double least = 1;
    for (Vec3 foot : scene->copy_sets[0].copies.foot)
      least = std::min(least, host.face_normal(host.closest(DVec3(foot))->triangle).y);
    return least;
  };
  EXPECT_GT(steepest("30"), std::cos(radians(32.0)));
  EXPECT_LT(steepest("170"), 0);
}

TEST(SowBodies, AreSunkAlongTheNormal) {
  std::string sunk = tufts(40, R"(, "slope": 170)");
  sunk.replace(sunk.find("\"lean\""), 0, R"("raise": -0.02, )");
  Scene scene = *on_boulder(sunk);
  TriangleSurface host = skin(scene);
  int deep = 0;
  for (Vec3 foot : scene.copy_sets[0].copies.foot) {
    EXPECT_TRUE(host.inside(DVec3(foot)));
    // Less where another part of the surface is nearer.
    double distance = host.closest(DVec3(foot))->distance;
    EXPECT_LT(distance, 0.0201);
    deep += distance > 0.018;
  }
  EXPECT_GT(deep, 30);
}

TEST(SowBodies, OnlyTheLowestLayerGrowsUpToColonies) {
  auto nearest = [](const std::string& layer) {
    Scene scene = *on_boulder(
        R"({"kind": "massive", "across": 0.8, "relief": "plain", "edge": 0.02, "place": {"at": [[0, 0]], "on": ["boulder"]}}, )" +
        tufts(400, R"(, "slope": 90, "layer": ")" + layer + '"'));
    auto met = skin(scene).crossing(DVec3(0, 9, 0), DVec3(0, -9, 0));
    Vec3 foot(0, 9 - 18 * met->share, 0);
    float least = 9;
    for (Vec3 other : scene.copy_sets[0].copies.foot) least = std::min(least, glm::distance(foot, other));
    return least;
  };
  EXPECT_GT(nearest("shrubs"), 0.24f);
  EXPECT_LT(nearest("herbs"), 0.24f);
}

TEST(SowBodies, AreTheSameOnAnyNumberOfThreads) {
  limit_threads(1);
  Scene one = *on_boulder(tufts(60, ""));
  limit_threads(0);
  Scene many = *on_boulder(tufts(60, ""));
  EXPECT_EQ(one.copy_sets[0].copies.foot, many.copy_sets[0].copies.foot);
}

TEST(SowBodies, SayWhatIsMissing) {
  std::string elsewhere = tufts(5, "");
  elsewhere.replace(elsewhere.find("boulder"), 7, "builder");
  Result<Scene> scene = on_boulder(elsewhere);
  ASSERT_FALSE(scene.ok());
  std::string said = scene.errors()[0].text();
  EXPECT_NE(said.find("/organisms/1/place/on/0: no organism \"builder\""), std::string::npos) << said;
  Result<Scene> crowded = on_boulder(tufts(4000, ""));
  ASSERT_TRUE(crowded.ok());
  ASSERT_FALSE(crowded->notes.empty());
  EXPECT_NE(crowded->notes.back().find("found room"), std::string::npos);
}

}  // namespace
}  // namespace frond
