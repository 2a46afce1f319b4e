#include "scene/reef.h"

#include <gtest/gtest.h>

#include <map>

#include "appearance/bleaching.h"
#include "core/bounds.h"
#include "core/linear.h"
#include "scene/copies.h"

namespace frond {
namespace {

/// Sixty years of a small reef in six seconds.
const char* const kText = R"({
  "seed": 5, "film": {"frames": 144, "fps": 24, "size": [160, 90], "quality": "draft"},
  "scene": {"setting": "underwater", "camera": {"location": [0, 2, 5], "look_at": [0, 0, 0]}},
  "reef": {"area": [5, 5], "years": 60, "species": [{"name": "tabular", "organism": "mound"},
           {"name": "branching", "organism": "staghorn"}, "massive"]},
  "events": [{"year": 30, "heat": 9}, {"year": 50, "storm": 0.8}],
  "organisms": [
    {"kind": "massive", "name": "mound", "count": 0, "sown": {"models": 2}, "across": 0.4, "height": 0.24, "edge": 0.03, "relief": "plain"},
    {"kind": "coral", "name": "staghorn", "count": 0, "sown": {"models": 2}, "steps": 2}]})";

class ReefFilm : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    Result<Preset> preset = read_preset(kText, "test.json", {});
    ASSERT_TRUE(preset) << preset.errors().front().text();
    Result<Scene> built = build_scene(*preset);
    ASSERT_TRUE(built) << built.errors().front().text();
    scene = new Scene(std::move(*built));
    history = new ReefHistory(reef_history(*preset));
  }
  static void TearDownTestSuite() {
    delete scene;
    delete history;
  }
  /// Seconds of the film at a year.
  static double at(double year) { return year / 10; }

  struct Seen {
    ColonyState state = ColonyState::living;
    Vec2 size{0};  // radius, height
    int copies = 0;
  };
  /// Copies that are there at a year, by their place.
  static std::map<std::pair<float, float>, Seen> seen(double year) {
    std::map<std::pair<float, float>, Seen> all;
    for (const CopySet& set : scene->copy_sets) {
      const Copies& c = set.copies;
      for (std::size_t i = 0; i < c.size(); ++i) {
        if (!c.there(i, at(year))) continue;
        Seen& one = all[{c.foot[i].x, c.foot[i].z}];
        const ModelSize& model = *set.organism.sown->size;
        Vec3 scale = c.scale_at(i, at(year));
        one = {set.organism.sown->state, {scale.x * model.crown, scale.y * model.height}, one.copies + 1};
      }
    }
    return all;
  }

  static Scene* scene;
  static ReefHistory* history;
};
Scene* ReefFilm::scene = nullptr;
ReefHistory* ReefFilm::history = nullptr;

TEST_F(ReefFilm, DrawsEachLivingColonyOnceAsLargeAsItIs) {
  EXPECT_TRUE(scene->find_fault().empty()) << scene->find_fault();
  int drawn = 0;
  for (double year : {8.5, 24.2, 41.0, 59.5}) {
    auto all = seen(year);
    for (std::uint32_t i : living_at(*history, year)) {
      const ColonyLife& life = history->lives[i];
      ColonySize size = size_at(*history, i, year);
      auto found = all.find({life.x, life.z});
      if (life.species == 2) {
        EXPECT_EQ(found, all.end()) << "massive ones are drawn as nothing";
        continue;
      }
      if (size.radius < 0.03f) continue;
      ASSERT_NE(found, all.end()) << year;
      EXPECT_EQ(found->second.copies, 1);
      EXPECT_NEAR(found->second.size.x, size.radius, 0.1f * size.radius + 0.005f);
      EXPECT_NEAR(found->second.size.y, size.height, 0.1f * size.height + 0.005f);
      ++drawn;
    }
  }
  EXPECT_GT(drawn, 100);
}

TEST_F(ReefFilm, WhatHeatKillsIsWhiteThenUnderTurfAndWhatStormsRollLiesElsewhere) {
  int white = 0, rolled = 0;
  for (const ColonyLife& life : history->lives) {
    if (life.species == 2) continue;
    if (life.cause == ColonyDeath::heat && life.gone > life.died + 1) {
      auto then = seen(life.died + 0.1), later = seen(life.died + 0.9);
      auto found = then.find({life.x, life.z}), after = later.find({life.x, life.z});
      if (found == then.end() || after == later.end()) continue;  // too small to be drawn
      EXPECT_EQ(found->second.state, ColonyState::bleached);
      EXPECT_EQ(after->second.state, ColonyState::dead);
      if (++white > 5) break;
    }
  }
  EXPECT_GT(white, 5);
  for (const CopySet& set : scene->copy_sets)
    for (std::size_t i = 0; i < set.copies.size(); ++i)
      rolled += (set.copies.turn[i] * Vec3(0, 1, 0)).y < -0.3f;
  EXPECT_GT(rolled, 3);
}

TEST(Reef, IsDrawnAsTheFirstOfTheNameThatIsSown) {
  Result<Preset> preset = read_preset(
      R"({"scene": {"setting": "underwater"}, "reef": {"area": [2, 2], "years": 12, "species": [{"name": "brain", "arrival": 3, "organism": "brain"}]},
  "organisms": [{"kind": "massive", "name": "brain", "count": 1},
    {"kind": "massive", "name": "brain", "count": 0, "sown": {"models": 1}},
    {"kind": "massive", "name": "brain", "count": 0, "sown": {"models": 1}}]})",
      "test.json", {});
  ASSERT_TRUE(preset) << preset.errors().front().text();
  Result<Scene> built = build_scene(*preset);
  ASSERT_TRUE(built) << built.errors().front().text();
  ASSERT_FALSE(built->copy_sets.empty());
  for (const CopySet& set : built->copy_sets) EXPECT_EQ(set.entry, 1u);
}

TEST_F(ReefFilm, ModelsAreFittedToTheLargestColoniesAndPaleAsTheyDie) {
  for (const CopySet& set : scene->copy_sets) {
    Result<Model> model = grow_copy(set.organism, 0);
    ASSERT_TRUE(model);
    Appearance living = set.organism.grower->appearance();
    ColonyState state = set.organism.sown->state;
    if (model->solids.size() > 0) {
      Bounds box = bounds_of(model->solids);
      EXPECT_NEAR(box.high.y, set.organism.sown->size->height, 0.1 * set.organism.sown->size->height);
      EXPECT_NEAR(std::max(box.high.x, -box.low.x), set.organism.sown->size->crown,
                  0.3 * set.organism.sown->size->crown);
      EXPECT_TRUE(model->solids.find_fault().empty());
    } else {
      Vec3 color = linear(set.appearance.look.branches.skin->tint.base),
           before = linear(living.look.branches.skin->tint.base);
      Vec3 expected = state == ColonyState::living     ? before
                      : state == ColonyState::bleached ? bleached_color(before)
                                                       : dead_color(before);
      EXPECT_NEAR(glm::distance(color, expected), 0, 1e-3);
    }
  }
  EXPECT_GE(scene->copy_sets.size(), 5u);
}

}  // namespace
}  // namespace frond
