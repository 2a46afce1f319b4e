#include "emit/copies.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "emit/frame.h"
#include "scene/scene.h"

namespace frond {
namespace {

std::string preset_text(const std::string& film, const std::string& more = "") {
  return R"({"film": )" + film +
         R"(, "scene": {"setting": "forest", "camera": {"location": [0, 2, 40], "look_at": [0, 2, 0]},
      "forest": {"terrain": {"size": 120, "hills": 2}}},
    "organisms": [{"kind": "tree", "name": "oak", "count": 300, "years": 9, "sown": {"models": 2, "where": {"radius": 1}})" +
         more + "}]}";
}

Scene scene_of(const std::string& text) {
  Result<Preset> preset = read_preset(text, "test.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  Result<Scene> scene = build_scene(*preset);
  if (!scene) ADD_FAILURE() << scene.errors().front().text();
  return *scene;
}

const std::string kStill = R"({"frames": 1, "size": [800, 600], "quality": "good"})";

TEST(CopyPlan, NearCopiesAreFinerAndWhatIsBehindUsIsLeftOut) {
  Scene scene = scene_of(preset_text(kStill));
  CopyPlan plan = plan_copies(scene);
  const Copies& copies = scene.stands[0].copies;
  double worst[8] = {}, behind = 0;
  for (std::size_t i = 0; i < copies.size(); ++i) {
    int level = plan.level[0][i];
    double far = glm::distance(copies.foot[i], Vec3(0, 2, 40));
    if (level == CopyPlan::kUnseen) {
      ++behind;
      EXPECT_TRUE(copies.foot[i].z > 20 || std::abs(copies.foot[i].x) > 10) << "in full view";
      continue;
    }
    worst[level] = std::max(worst[level], far);
  }
  EXPECT_GT(behind, 0);
  for (int level = 1; level < 8; ++level) EXPECT_TRUE(worst[level] == 0 || worst[level] > worst[level - 1]);
  for (std::size_t i = 0; i < copies.size(); ++i)
    for (std::size_t k = 0; k < copies.size(); ++k) {
      if (plan.level[0][i] == CopyPlan::kUnseen || plan.level[0][k] == CopyPlan::kUnseen) continue;
      double a = glm::distance(copies.foot[i], Vec3(0, 2, 40)),
             b = glm::distance(copies.foot[k], Vec3(0, 2, 40));
      EXPECT_TRUE(a + 2 >= b || plan.level[0][i] <= plan.level[0][k]);
    }
}

TEST(CopyPlan, TheSameFilmLargerIsFiner) {
  Scene scene = scene_of(preset_text(kStill));
  CopyPlan small = plan_copies(scene);
  scene.film.size = {3200, 2400};
  CopyPlan large = plan_copies(scene);
  int finer = 0;
  for (std::size_t i = 0; i < small.level[0].size(); ++i) {
    EXPECT_LE(large.level[0][i], small.level[0][i]);
    finer += large.level[0][i] < small.level[0][i];
  }
  EXPECT_GT(finer, 50);
}

/// Counts the parts of all files, and returns what they and the frame say.
std::pair<std::string, std::string> texts(const Scene& scene, CopyPlan& plan) {
  std::string models;
  for (ModelFile& file : plan.files) {
    const SownStand& stand = scene.stands[file.stand];
    std::string text = model_text(file, stand, *grow_copy(stand.organism, file.model));
    file.parts = model_parts(text).value_or(0);
    EXPECT_EQ(file.parts, 2) << "wood and leaves";
    models += text;
  }
  return {models, still_copies_text({}, scene, plan)};
}

TEST(CopyText, PlacesOnlyWhatItsFilesDeclare) {
  Scene scene = scene_of(preset_text(kStill));
  CopyPlan plan = plan_copies(scene);
  auto [models, frame] = texts(scene, plan);
  std::set<std::string> declared, placed, looks;
  std::regex declare("#declare (Model_\\w+) = mesh2"), place("object\\{(Model_\\w+) matrix<"),
      look("(Model_\\w+)_Look\\(Tint0\\[");
  auto collect = [](const std::string& text, const std::regex& what, std::set<std::string>& into) {
    for (std::sregex_iterator it(text.begin(), text.end(), what), end; it != end; ++it) into.insert((*it)[1]);
  };
  collect(models, declare, declared);
  collect(frame, place, placed);
  collect(frame, look, looks);
  EXPECT_FALSE(placed.empty());
  EXPECT_EQ(placed, declared);
  EXPECT_EQ(looks, declared);
  for (const ModelFile& file : plan.files)
    EXPECT_NE(frame.find("#include \"" + file.name + "\""), frame.npos);
}

TEST(CopyText, AWholeFrameHoldsThem) {
  Scene scene = scene_of(preset_text(kStill));
  CopyPlan plan = plan_copies(scene);
  texts(scene, plan);
  Result<std::string> text = frame_text(scene, prepare_frames(scene, plan), "{{ground}}|{{organisms}}", 1);
  ASSERT_TRUE(text);
  EXPECT_LT(text->find("object{Model_"), text->find('|'));
}

TEST(CopyText, WindMovesCopiesAndComesBack) {
  const std::string film = R"({"frames": 24, "fps": 12, "size": [320, 240]})";
  Scene scene = scene_of(preset_text(film, R"(, "wave": {"amplitude": 6, "speed": 0.7})"));
  CopyPlan plan = plan_copies(scene);
  auto [models, still] = texts(scene, plan);
  EXPECT_EQ(still.find("object{"), still.npos);
  std::string start = swaying_copies_text({}, scene, plan, 0);
  EXPECT_NE(start, swaying_copies_text({}, scene, plan, 0.5));
  EXPECT_EQ(start, swaying_copies_text({}, scene, plan, scene.film.length()));
}

TEST(CopyText, WhatIsTheSameInAFilmIsWrittenOnce) {
  Scene scene = scene_of(preset_text(R"({"frames": 3, "size": [320, 240]})"));
  scene.film.frames = 1;
  std::string whole = prepare_frames(scene).ground;
  ASSERT_GT(whole.size(), 4e6) << "land and litter";
  EXPECT_TRUE(prepare_frames(scene).files.empty());
  scene.film.frames = 3;
  FrameParts parts = prepare_frames(scene);
  ASSERT_EQ(parts.files.size(), 1u);
  EXPECT_EQ(parts.files[0].bytes, whole);
  EXPECT_EQ(parts.ground, "#include \"" + parts.files[0].name + "\"");
}

TEST(ModelParts, AreCountedInTheFirstLine) {
  EXPECT_EQ(model_parts("// 3 parts: 7 segments"), 3);
  EXPECT_EQ(model_parts("// 0 parts: "), 0);
  EXPECT_EQ(model_parts("// 12 birds"), std::nullopt);
  EXPECT_EQ(model_parts("#declare"), std::nullopt);
  EXPECT_EQ(model_parts(""), std::nullopt);
}

}  // namespace
}  // namespace frond
