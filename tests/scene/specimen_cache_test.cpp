#include "scene/specimen_cache.h"

#include <gtest/gtest.h>

#include <atomic>

#include "core/files.h"
#include "scene/scene.h"

namespace frond {
namespace {

const ProgressSink kUnwatched{[](auto, auto) {}, [] {}};

Preset preset_with(const std::string& path, const std::vector<std::string>& sets = {}) {
  Result<Preset> preset = read_preset(*read_file(path), path, sets);
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return preset ? *preset : Preset{};
}

Scene grown_with(const Preset& preset, SpecimenCache* cache) {
  Result<Scene> scene = build_scene(preset, kUnwatched, cache);
  if (!scene) ADD_FAILURE() << scene.errors().front().text();
  return scene ? std::move(*scene) : Scene{};
}

void expect_same(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.specimens.size(), b.specimens.size());
  for (std::size_t i = 0; i < a.specimens.size(); ++i) {
    const Specimen &s = a.specimens[i], &t = b.specimens[i];
    EXPECT_EQ(s.entry, t.entry);
    EXPECT_EQ(s.model.skeleton.position, t.model.skeleton.position);
    EXPECT_EQ(s.model.organs.position, t.model.organs.position);
    EXPECT_EQ(s.brightness, t.brightness);
    EXPECT_EQ(s.motion.growth.start, t.motion.growth.start);
    EXPECT_EQ(s.style.voxel, t.style.voxel);
  }
  EXPECT_EQ(a.notes, b.notes);
}

TEST(SpecimenCache, GivesTheSameSceneAsGrowingDoes) {
  for (const char* path :
       {"presets/thicket.json", "presets/ivy/column.json", "presets/trees/light_race.json"}) {
    std::vector<std::string> smaller;
    if (std::string_view(path).starts_with("presets/trees")) smaller = {"/defaults/years=4"};
    Preset preset = preset_with(path, smaller);
    SpecimenCache cache;
    Scene plain = grown_with(preset, nullptr), first = grown_with(preset, &cache),
          again = grown_with(preset, &cache);
    EXPECT_FALSE(first.grown.empty()) << path;
    EXPECT_TRUE(again.grown.empty()) << path;
    expect_same(plain, first);
    expect_same(plain, again);
  }
}

TEST(SpecimenCache, GrowsOnlyWhatWasChanged) {
  SpecimenCache cache;
  grown_with(preset_with("presets/thicket.json"), &cache);
  Preset other = preset_with("presets/thicket.json", {"/organisms/2/thickness/knob=2"});
  Scene changed = grown_with(other, &cache);
  EXPECT_EQ(changed.grown, std::vector<std::size_t>{2});
  expect_same(grown_with(other, nullptr), changed);
  // The camera and the light grow nothing.
  EXPECT_TRUE(
      grown_with(preset_with("presets/thicket.json", {"/scene/camera/angle=30", "/scene/water/caustics=0"}),
                 &cache)
          .grown.empty());
}

TEST(SpecimenCache, AnotherGroupGrowsNothing) {
  SpecimenCache cache;
  grown_with(preset_with("presets/thicket.json"), &cache);
  Preset grouped = preset_with("presets/thicket.json", {"/organisms/0/group=\"behind\""});
  EXPECT_EQ(grouped.organisms[0].group, "behind");
  EXPECT_TRUE(grown_with(grouped, &cache).grown.empty());
}

TEST(SpecimenCache, IvyGrowsAnewWhereItsHostDoes) {
  SpecimenCache cache;
  grown_with(preset_with("presets/ivy/column.json"), &cache);
  Preset other = preset_with("presets/ivy/column.json", {"/organisms/0/place/size_variation=0.5"});
  Scene changed = grown_with(other, &cache);
  EXPECT_EQ(changed.grown.size(), 2u);  // the column, and what creeps on it
  expect_same(grown_with(other, nullptr), changed);
}

TEST(SpecimenCache, IvyDoesNotGrowAnewOnAHostOfAnotherColour) {
  SpecimenCache cache;
  grown_with(preset_with("presets/ivy/column.json"), &cache);
  Preset other = preset_with("presets/ivy/column.json", {"/organisms/0/stone=\"#ffffff\""});
  Scene changed = grown_with(other, &cache);
  EXPECT_EQ(changed.grown, std::vector<std::size_t>{0});
  expect_same(grown_with(other, nullptr), changed);
}

TEST(SpecimenCache, ACameraThatFitsBeyondTheLandGrowsNothingTwice) {
  std::vector<std::string> sets{"/organisms/0/years=6", "/scene/camera/fit=[\"all\"]"};
  Preset preset = preset_with("presets/trees/oak.json", sets);
  sets.insert(sets.end(), {"/scene/camera/angle=2", "/organisms/0/years=6"});
  Preset far = preset_with("presets/trees/oak.json", sets);
  auto steps_of = [](const Preset& of, Scene& scene) {
    std::atomic<int> steps = 0;
    bool growing = false;
    ProgressSink watch{[&](std::string_view phase, auto) { growing = phase == "grow"; },
                       [&] { steps += growing; }};
    scene = *build_scene(of, watch);
    return steps.load();
  };
  Scene near_scene, far_scene;
  EXPECT_EQ(steps_of(preset, near_scene), steps_of(far, far_scene));
  ASSERT_GT(far_scene.setup.camera.location.at(0).z, 100) << "farther than the land was laid at first";
  // And it is what grows there at once.
  Preset there = far;
  there.setup.camera = far_scene.setup.camera;
  there.setup.camera.fit.clear();
  expect_same(grown_with(there, nullptr), far_scene);
}

TEST(SpecimenCache, ForgetsWhatWasNotUsedForLong) {
  SpecimenCache small(1);  // room for one bed
  Preset preset = preset_with("presets/thicket.json");
  grown_with(preset, &small);
  EXPECT_GE(grown_with(preset, &small).grown.size(), preset.organisms.size() - 1);
}

TEST(SpecimenCache, ASceneThatIsGivenUpIsAnError) {
  ProgressSink gone{[](auto, auto) {}, [] {}, [] { return true; }};
  EXPECT_FALSE(build_scene(preset_with("presets/thicket.json"), gone).ok());
}

}  // namespace
}  // namespace frond
