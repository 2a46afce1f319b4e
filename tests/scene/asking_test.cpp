#include <gtest/gtest.h>

#include <algorithm>

#include "scene/scene.h"

// Grammars that ask the world where they grow.

namespace frond {
namespace {

Scene asked_scene(const std::string& organisms) {
  Result<Preset> preset =
      read_preset(R"j({"seed": 3, "scene": {"setting": "underwater"}, "organisms": [)j" + organisms + "]}",
                  "asking.json", {});
  EXPECT_TRUE(preset) << preset.errors()[0].text();
  Result<Scene> scene = build_scene(*preset);
  EXPECT_TRUE(scene) << scene.errors()[0].text();
  return std::move(*scene);
}

const Specimen& one_called(const Scene& scene, std::string_view name) {
  return *std::ranges::find(scene.specimens, name, &Specimen::name);
}

constexpr const char* kRoof =
    R"j({"kind": "rock", "name": "roof", "size": 1, "place": {"at": [[0, 0]], "raise": 0.4, "rock": 0, "size_variation": 0}},)j";

std::string shy() {
  return R"j({"kind": "coral", "name": "shy", "form": "own", "place": {"at": [[0, 0]], "rock": 0, "size_variation": 0},
      "grammar": {"axiom": "F(0.05)?E(0,0)A", "steps": 4, "symbols": ["?E"], "rules": [
        "?E(k,l) < A : l > 0.8 -> [&(30)F(0.05)?E(0,0)A]/(180)[&(30)F(0.05)?E(0,0)A]", "?E(k,l) -> "]}})j";
}

TEST(Asking, BranchesEndWhereTheSkyIsClosed) {
  std::size_t open = one_called(asked_scene(shy()), "shy").model.skeleton.size();
  std::size_t shaded = one_called(asked_scene(kRoof + shy()), "shy").model.skeleton.size();
  EXPECT_GT(open, 2 * shaded);
}

TEST(Asking, RunnersKeepTheirDistanceFromWhatTheyGrowOn) {
  Scene scene = asked_scene(
      R"j({"kind": "rock", "name": "boulder", "size": 0.8, "place": {"at": [[0, 0]], "size_variation": 0}},
      {"kind": "plant", "name": "runner", "place": {"on": ["boulder"], "upright": 1, "at": [[0, 0]]},
       "grammar": {"axiom": "&(84)?H(0,0,0)?U(0,0,0)?E(1,0,0,0,0)R", "steps": 12, "symbols": ["?E"], "rules": [
         "?H(a,b,c)?U(e,f,g)?E(k,d,x,y,z) < R -> ^(57*(e*x+f*y+g*z)*(max(-0.6,min(0.6,20*(0.02-d)))-a*x-b*y-c*z))F(0.02)?H(0,0,0)?U(0,0,0)?E(1,0,0,0,0)R",
         "?H(a,b,c) -> ", "?U(a,b,c) -> ", "?E(k,d,x,y,z) -> "]}})j");
  const Skeleton& runner = one_called(scene, "runner").model.skeleton;
  Result<TriangleSurface> boulder = TriangleSurface::build(merged(one_called(scene, "boulder").model.solids));
  ASSERT_TRUE(boulder);
  ASSERT_GT(runner.size(), 30u);
  float farthest = 0;
  for (std::size_t i = 20; i < runner.size(); ++i) {
    auto contact = boulder->closest(DVec3(runner.position[i]), 0.5);
    ASSERT_TRUE(contact);
    farthest = std::max(farthest, static_cast<float>(contact->distance));
  }
  EXPECT_LT(farthest, 0.06f);
}

TEST(Asking, TipsComeNearerToTheFood) {
  auto hungry = [](const std::string& place) {
    Scene scene = asked_scene(
        R"j({"kind": "coral", "name": "hungry", "form": "own", "place": {"at": [[0, 0]], "rock": 0, "size_variation": 0},
      "food": {"strength": 1, "position": )j" +
        place +
        R"j(}, "grammar": {"axiom": "F(0.06)?E(2,9,0,0,0)A(9)", "steps": 7, "symbols": ["?E"], "rules": [
        "?E(k,d,x,y,z) < A(p) : d < p - 0.03 -> [&(30)F(0.08)?E(2,0,0,0,0)A(d)]/(120)[&(30)F(0.08)?E(2,0,0,0,0)A(d)]",
        "?E(k,d,x,y,z) -> "]}})j");
    float x = 0;
    const Skeleton& s = one_called(scene, "hungry").model.skeleton;
    for (const Vec3& p : s.position) x += p.x / static_cast<float>(s.size());
    return x;
  };
  EXPECT_GT(hungry("[1, 0.8, 0]"), 0.1f);
  EXPECT_LT(hungry("[-1, 0.8, 0]"), -0.1f);
}

TEST(Asking, IsRefusedWhereDistancesWouldMeanNothing) {
  Result<Preset> preset = read_preset(
      R"j({"organisms": [{"kind": "coral", "form": "own", "height": 2,
      "grammar": {"axiom": "F?E(0,0)", "steps": 1, "symbols": ["?E"]}}]})j",
      "asking.json", {});
  ASSERT_FALSE(preset);
  EXPECT_NE(preset.errors()[0].text().find("/organisms/0/height"), std::string::npos)
      << preset.errors()[0].text();
}

}  // namespace
}  // namespace frond
