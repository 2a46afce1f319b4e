#include "emit/copies.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "emit/texts.h"
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

CopyPlan planned(const Scene& scene) {
  Views views(scene);
  CopyPlan plan = views.empty_plan();
  for (std::size_t s = 0; s < scene.copy_sets.size(); ++s) {
    const CopySet& set = scene.copy_sets[s];
    for (int model = 0; model < set.organism.sown->models; ++model) {
      std::vector<Surfel> surfels = surfels_of(set.appearance.look, *grow_copy(set.organism, model));
      Views::add(plan, s, views.plan(s, model, surfels));
      plan.surfels[s].push_back(std::move(surfels));
    }
  }
  return plan;
}

/// The finest level at which each copy of the first stand is drawn; kLevelCount: it is not.
std::vector<int> finest(const Scene& scene, const CopyPlan& plan, std::size_t stretch = 0) {
  std::vector<int> level(scene.copy_sets[0].copies.size(), kLevelCount);
  for (const Drawn& one : plan.drawn[stretch][0]) level[one.copy] = std::min<int>(level[one.copy], one.level);
  return level;
}

TEST(CopyPlan, NearCopiesAreFinerAndWhatIsBehindUsIsLeftOut) {
  Scene scene = scene_of(preset_text(kStill));
  const Copies& copies = scene.copy_sets[0].copies;
  std::vector<int> level = finest(scene, planned(scene));
  double nearest[kLevelCount + 1] = {1e9, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9};
  int behind = 0;
  for (std::size_t i = 0; i < copies.size(); ++i) {
    if (level[i] == kLevelCount) {
      ++behind;
      EXPECT_TRUE(copies.foot[i].z > 20 || std::abs(copies.foot[i].x) > 10) << "in full view";
    } else if (copies.foot[i].z < 30) {  // in view, not only its shadow
      nearest[level[i]] = std::min<double>(nearest[level[i]], glm::distance(copies.foot[i], Vec3(0, 2, 40)));
    }
  }
  EXPECT_GT(behind, 0);
  for (int k = 1; k < kLevelCount; ++k) EXPECT_GE(nearest[k], nearest[k - 1] < 1e9 ? nearest[k - 1] : 0);
}

TEST(CopyPlan, TheSameFilmLargerIsFiner) {
  Scene scene = scene_of(preset_text(kStill));
  std::vector<int> small = finest(scene, planned(scene));
  scene.film.size = {3200, 2400};
  std::vector<int> large = finest(scene, planned(scene));
  int finer = 0;
  for (std::size_t i = 0; i < small.size(); ++i) {
    EXPECT_LE(large[i], small[i]);
    finer += large[i] < small[i];
  }
  EXPECT_GT(finer, 50);
}

TEST(CopyPlan, OfATallTreeWhatIsNearIsFine) {
  Scene scene = scene_of(preset_text(kStill));
  CopySet& set = scene.copy_sets[0];
  std::vector<Surfel> surfels;  // of a pole, eighteen metres high, right before the camera
  for (int i = 0; i < 90; ++i)
    surfels.push_back({Vec3(0, 0.2f * static_cast<float>(i), 0), 1, 0.2f, Vec3(0.5f), 0.3f});
  set.copies = {{0}, {Vec3(0, 0, 38)}, {Quat(1, 0, 0, 0)}, {1}, {0}, {}};
  ModelPlan plan = Views(scene).plan(0, 0, surfels);
  ModelBlocks blocks = blocks_of(surfels);
  ASSERT_EQ(blocks.count(), 6);
  std::vector<Drawn> drawn = plan.drawn[0];
  ASSERT_EQ(drawn.size(), 6u) << "its top throws a shadow";
  for (std::size_t k = 1; k < drawn.size(); ++k) EXPECT_GE(drawn[k].level, drawn[k - 1].level);
  EXPECT_LT(drawn.front().level, drawn.back().level);
}

TEST(CopyPlan, PiecesThatThrowShadowsAreNoWiderThanTheirBlur) {
  Scene scene = scene_of(preset_text(kStill));
  std::vector<Surfel> surfels;  // of a pole of thirty metres
  for (int i = 0; i < 150; ++i)
    surfels.push_back({Vec3(0, 0.2f * static_cast<float>(i), 0), 1, 0.2f, Vec3(0.5f), 0.3f});
  Copies& copies = scene.copy_sets[0].copies = {};
  for (double turn = 0; turn < 2 * kPi; turn += kPi / 8) {  // round the camera, as near as its top sees it
    copies.model.push_back(0), copies.scale.push_back(1), copies.tint.push_back(0);
    copies.turn.push_back(Quat(1, 0, 0, 0));
    copies.foot.push_back(Vec3(14 * std::cos(turn), 0, 40 + 14 * std::sin(turn)));
  }
  ModelBlocks blocks = blocks_of(surfels);
  constexpr double kSun = 0.0093;  // radians across
  int above = 0;
  ModelPlan plan = Views(scene).plan(0, 0, surfels);
  for (const Drawn& one : plan.drawn[0]) {
    if (one.block == ModelFile::kWhole || blocks.middle(one.block).y < 20) continue;
    ++above;
    EXPECT_LE(2 * kLevels[one.level].grain, kSun * blocks.middle(one.block).y) << "a leaf is two grains wide";
  }
  EXPECT_GT(above, 4);
}

TEST(CopyPlan, AMovingCameraHasStretchesThatDifferLittle) {
  std::string film = R"({"frames": 96, "fps": 24, "size": [480, 270]})";
  std::string text = preset_text(film);
  std::string still = R"("location": [0, 2, 40])", walk = R"("location": [[0, [0, 2, 40]], [4, [0, 2, 34]]])";
  Scene scene = scene_of(text);
  EXPECT_EQ(planned(scene).drawn.size(), 1u) << "of a camera that stands";
  text.replace(text.find(still), still.size(), walk);
  scene = scene_of(text);
  CopyPlan plan = planned(scene);
  ASSERT_EQ(plan.drawn.size(), 24u);
  EXPECT_EQ(plan.stretch_of(4), 0u);
  EXPECT_EQ(plan.stretch_of(5), 1u);
  for (std::size_t k = 1; k < plan.drawn.size(); ++k) {
    std::vector<int> before = finest(scene, plan, k - 1), after = finest(scene, plan, k);
    int changed = 0, drawn = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      drawn += before[i] < kLevelCount;
      changed += before[i] != after[i];
      if (before[i] < kLevelCount && after[i] < kLevelCount) {
        // What the camera brushes past comes to the finest level from two away: as far as it may be seen.
        bool brushed = std::min(before[i], after[i]) == 0;
        EXPECT_LE(std::abs(before[i] - after[i]), brushed ? 2 : 1);
      }
    }
    EXPECT_LT(changed, drawn / 16);
  }
}

TEST(CopyPlan, ACameraThatZoomsMovesToo) {
  std::string text = preset_text(R"({"frames": 48, "fps": 24, "size": [480, 270]})");
  std::string still = R"("look_at": [0, 2, 0])";
  text.replace(text.find(still), still.size(), still + R"(, "angle": [[0, 60], [2, 6]])");
  Scene scene = scene_of(text);
  CopyPlan plan = planned(scene);
  ASSERT_EQ(plan.drawn.size(), 12u);
  std::vector<int> wide = finest(scene, plan, 0), near = finest(scene, plan, 11);
  int finer = 0;
  for (std::size_t i = 0; i < wide.size(); ++i) finer += near[i] < wide[i];
  EXPECT_GT(finer, 5);
}

TEST(ModelBlocks, HoldAllOfAModelOnce) {
  Scene scene = scene_of(preset_text(kStill));
  const CopySet& set = scene.copy_sets[0];
  Model model = *grow_copy(set.organism, 0);
  std::vector<Vec3> corners{Vec3(-4, 0, -4), Vec3(4, 3, 4), Vec3(0, 8, 0)};
  ModelBlocks blocks(corners);
  EXPECT_EQ(blocks.count(), 3);
  for (int b = 0; b < blocks.count(); ++b) {
    EXPECT_EQ(blocks.of(blocks.middle(b)), b);
  }
  for (const Vec3& at : corners) EXPECT_LT(glm::distance(at, blocks.middle(blocks.of(at))), blocks.radius());
  EXPECT_EQ(ModelBlocks(std::vector<Vec3>{Vec3(0), Vec3(0, 4, 1)}).count(), 1);
  for (const CopyPart& part : copy_parts(set.appearance.look, model, kLevels[2], &blocks)) {
    ASSERT_EQ(part.block.size(), part.surface.triangle.size());
    double whole = area(part.surface), sum = 0;
    std::size_t triangles = 0;
    for (int b = 0; b < blocks.count(); ++b) {
      Surface some = in_block(part, b);
      EXPECT_EQ(some.find_fault(), "");
      sum += area(some);
      triangles += some.triangle.size();
    }
    EXPECT_EQ(triangles, part.surface.triangle.size());
    EXPECT_NEAR(sum, whole, 1e-4 * whole);
  }
}

/// Counts the parts of all files, and returns what they and the frame say.
std::pair<std::string, std::string> texts(const Scene& scene, CopyPlan& plan) {
  std::string models;
  for (ModelFile& file : plan.files) {
    const CopySet& set = scene.copy_sets[file.copy_set];
    const std::vector<Surfel>& surfels = plan.surfels[file.copy_set][static_cast<std::size_t>(file.model)];
    ModelText text = model_texts({file}, set, *grow_copy(set.organism, file.model), blocks_of(surfels))[0];
    file.parts = text.parts;
    EXPECT_LE(file.parts.size(), 2u) << "wood and leaves, or what of them is large enough there";
    models += text.file_text();
  }
  return {models, model_includes_text(scene, plan, 0) + still_copies_text({}, scene, plan, 0).text};
}

TEST(CopyText, PlacesOnlyWhatItsFilesDeclare) {
  Scene scene = scene_of(preset_text(kStill));
  CopyPlan plan = planned(scene);
  auto [models, frame] = texts(scene, plan);
  std::set<std::string> declared, placed, looks;
  std::regex declare("#declare (Model_\\w+) = (mesh2|union|object)"), place("object\\{(Model_\\w+) matrix<"),
      look("(Model_\\w+)_Look\\(Tint0\\[");
  auto collect = [](const std::string& text, const std::regex& what, std::set<std::string>& into) {
    for (std::sregex_iterator it(text.begin(), text.end(), what), end; it != end; ++it) into.insert((*it)[1]);
  };
  collect(models, declare, declared);
  collect(frame, place, placed);
  collect(frame, look, looks);
  EXPECT_FALSE(placed.empty());
  EXPECT_EQ(placed, looks);
  collect(models, std::regex("object\\{(Model_\\w+)\\}"), placed);  // those that others are put together from
  EXPECT_EQ(placed, declared);
  for (const ModelFile& file : plan.files)
    EXPECT_NE(frame.find("#include \"" + file.name + "\""), frame.npos);
}

TEST(CopyText, PicturesAreReadOnceAFrame) {
  Scene scene = scene_of(preset_text(
      kStill,
      R"(, "leaves": {"kind": "lobed", "picture": {"colors": ["#8aa548", "#7b993e"], "luster": {"yellow": 1}}},
                  "coat": {"pattern": "furrowed"})"));
  CopyPlan plan = planned(scene);
  std::string models = texts(scene, plan).first;
  std::set<std::string> declared;
  std::regex declares(
      "#ifndef \\((\\w+)\\) #declare (\\w+) = (?:pigment|normal)\\{Copy_\\w+\\(\"[^\"]+\",[0-9.]+\\)\\} "
      "#end");
  for (std::sregex_iterator it(models.begin(), models.end(), declares), end; it != end; ++it) {
    EXPECT_EQ((*it)[1], (*it)[2]);
    declared.insert((*it)[1]);
  }
  EXPECT_EQ(declared.size(), 2u * 2 + 2) << "two leaves, each seen from both sides, and bark";
  std::string rest = std::regex_replace(models, declares, "");
  EXPECT_EQ(rest.find(".png"), rest.npos) << "a file that is named again is read again";
  for (const std::string& name : declared) EXPECT_NE(rest.find(name), rest.npos) << name << " is used";
}

TEST(CopyText, AWholeFrameHoldsThem) {
  Scene scene = scene_of(preset_text(kStill));
  CopyPlan plan = planned(scene);
  texts(scene, plan);
  Result<std::string> text = frame_text(scene, prepare_frames(scene, plan), "{{ground}}|{{organisms}}", 1);
  ASSERT_TRUE(text);
  EXPECT_LT(text->find("object{Model_"), text->find('|'));
}

TEST(CopyText, WindMovesCopiesAndComesBack) {
  const std::string film = R"({"frames": 24, "fps": 12, "size": [320, 240]})";
  Scene scene = scene_of(preset_text(film, R"(, "wave": {"amplitude": 6, "speed": 0.7})"));
  CopyPlan plan = planned(scene);
  auto [models, still] = texts(scene, plan);
  EXPECT_EQ(still.find("object{"), still.npos);
  std::string start = swaying_copies_text({}, scene, plan, 1, scene.film.time(1)).text;
  EXPECT_NE(start, swaying_copies_text({}, scene, plan, 7, scene.film.time(7)).text);
  EXPECT_EQ(start, swaying_copies_text({}, scene, plan, 25, scene.film.time(25)).text)
      << "where the film begins again";
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
  EXPECT_EQ(parts.ground, "#include \"" + parts.files[0].name + "\"\n") << "on a line of its own";
}

}  // namespace
}  // namespace frond
