// Scenes of which only some organisms grow at once: for those who wait for a picture.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "organisms/grower.h"
#include "scene/scene.h"
#include "scene/specimen_cache.h"

namespace frond {
namespace {

using Entries = std::vector<std::size_t>;

/// A rock, a coral that stands on it, and a plant beside it.
Preset shore(double rock_size, double coral_height = 0.2) {
  Result<Preset> preset = read_preset(
      fmt::format(
          R"({{"seed": 3, "film": {{"frames": 1}}, "scene": {{"setting": "underwater", "floor": {{"stones": 0}}}},
        "organisms": [
          {{"kind": "rock", "name": "rock", "size": {}, "depth": 5, "place": {{"at": [[0, 0]]}}}},
          {{"kind": "coral", "name": "coral", "steps": 3, "height": {}, "place": {{"at": [[0, 0]], "on": ["rock"]}}}},
          {{"kind": "plant", "name": "plant", "height": 0.3, "place": {{"at": [[2, 0]], "rock": 0}},
           "grammar": {{"axiom": "F", "steps": 2, "rules": ["F -> FF"]}}}}
        ]}})",
          rock_size, coral_height),
      "shore", {});
  EXPECT_TRUE(preset.ok()) << (preset ? "" : preset.errors()[0].text());
  return *preset;
}

Scene grown(const Preset& preset, SpecimenCache& cache, const EntryFilter& only = {}) {
  Result<Scene> scene = build_scene(preset, {[](auto, auto) {}, [] {}}, &cache, only);
  EXPECT_TRUE(scene.ok()) << (scene ? "" : scene.errors()[0].text());
  return std::move(*scene);
}

/// Where all nodes and triangles are.
std::string places(const Scene& scene) {
  std::string text;
  for (const Specimen& s : scene.specimens) {
    text += s.name;
    for (Vec3 p : s.model.skeleton.position) text += fmt::format(" {} {} {}", p.x, p.y, p.z);
    for (std::size_t i = 0; i < s.model.solids.size(); ++i)
      text += fmt::format(" {} {}", s.model.solids.position[i].y,
                          s.model.solids.shapes[s.model.solids.shape[i]].surface.triangle.size());
  }
  return text;
}

TEST(EntryFilter, GrowsJustWhatIsWantedAmongWhatIsThere) {
  SpecimenCache cache;
  grown(shore(0.6), cache);
  Scene other_rock = grown(shore(0.8), cache, std::set<std::size_t>{0});
  EXPECT_EQ(other_rock.grown, Entries{0});
  EXPECT_EQ(other_rock.missing, Entries{1}) << "it stands on the rock";
  Scene other_coral = grown(shore(0.6, 0.3), cache, std::set<std::size_t>{1});
  EXPECT_EQ(other_coral.grown, Entries{1});
  EXPECT_TRUE(other_coral.missing.empty());
  SpecimenCache another;
  EXPECT_EQ(places(other_coral), places(grown(shore(0.6, 0.3), another))) << "it is the scene itself";
}

TEST(EntryFilter, ShowsWhatHasGrownSoFar) {
  SpecimenCache cache;
  EXPECT_EQ(grown(shore(0.6), cache, EntryFilter(std::in_place)).missing, (Entries{0, 2, 1}));
  grown(shore(0.6), cache);
  Scene all = grown(shore(0.6), cache, EntryFilter(std::in_place));
  EXPECT_TRUE(all.missing.empty() && all.grown.empty());
  EXPECT_EQ(all.specimens.size(), 3u);
}

TEST(EntryFilter, WhatGrewFilteredIsNotTakenForTheWhole) {
  SpecimenCache cache, another;
  // The coral is asked for where its rock is not there yet.
  EXPECT_EQ(grown(shore(0.6), cache, std::set<std::size_t>{1}).missing, (Entries{0, 2, 1}));
  grown(shore(0.7), cache, std::set<std::size_t>{0, 1});
  for (double size : {0.6, 0.7})
    EXPECT_EQ(places(grown(shore(size), cache)), places(grown(shore(size), another))) << size;
}

TEST(EntryFilter, ARoughTreeIsAsTallAndHasFewerTwigs) {
  Preset preset = *read_preset(R"({"film": {"frames": 1}, "scene": {"setting": "studio"},
      "organisms": [{"kind": "tree", "years": 12, "place": {"at": [[0, 0]]}}]})",
                               "tree", {});
  Preset rough = preset;
  rough.organisms[0].grower = preset.organisms[0].grower->coarse(0.3);
  ASSERT_NE(rough.organisms[0].grower, nullptr);
  auto tall = [](const Scene& scene) {
    float height = 0;
    for (Vec3 p : scene.specimens.at(0).model.skeleton.position) height = std::max(height, p.y);
    return height;
  };
  Scene fine = *build_scene(preset), coarse = *build_scene(rough);
  EXPECT_LT(10 * coarse.nodes(), 6 * fine.nodes());
  EXPECT_NEAR(tall(coarse), tall(fine), 0.35 * tall(fine));
}

TEST(EntryFilter, ARoughCoralOrPlantHasNoMoreThanItsShareOfTheNodes) {
  Preset preset = *read_preset(R"({"scene": {"setting": "studio"}, "organisms": [
      {"kind": "coral", "name": "coral", "steps": 7}, {"kind": "plant", "name": "plant", "height": 1,
       "grammar": {"axiom": "F", "steps": 5, "angle": 25, "rules": ["F -> F[+F]F[-F]F"]}}]})",
                               "rough", {});
  for (const Organism& o : preset.organisms) {
    double whole = o.grower->estimate_size(Seed{1})->nodes;
    for (double share : {0.5, 0.1, 0.02}) {
      std::shared_ptr<const Grower> rough = o.grower->coarse(share);
      ASSERT_NE(rough, nullptr) << o.name;
      EXPECT_LE(rough->estimate_size(Seed{1})->nodes, share * whole) << o.name;
      EXPECT_GT(rough->estimate_size(Seed{1})->nodes, 0) << o.name;
    }
  }
}

TEST(EntryFilter, ARoughOneIsNoFaultAndHasFewerTriangles) {
  Preset reef = *read_preset(R"({"scene": {"setting": "underwater"}, "organisms": [
      {"kind": "rock", "name": "rock", "size": 1, "depth": 7, "tolerance": 0.0005},
      {"kind": "massive", "name": "massive"}, {"kind": "columnar", "name": "columnar"},
      {"kind": "shell", "name": "shell", "detail": 100000}, {"kind": "table", "name": "table"},
      {"kind": "foliose", "name": "foliose"}, {"kind": "tube", "name": "tube"}]})",
                             "reef", {});
  for (const Organism& o : reef.organisms) {
    std::shared_ptr<const Grower> coarse = o.grower->coarse(0.2);
    ASSERT_NE(coarse, nullptr) << o.name;
    EXPECT_TRUE(coarse->review().faults.empty());
    EXPECT_LT(coarse->estimate_size(Seed{1})->triangles, o.grower->estimate_size(Seed{1})->triangles)
        << o.name;
    std::optional<Spread> was = o.grower->spread(), now = coarse->spread();
    ASSERT_EQ(was.has_value(), now.has_value());
    if (!was) continue;
    EXPECT_EQ(was->across, now->across) << "it claims the same space";
  }
}

}  // namespace
}  // namespace frond
