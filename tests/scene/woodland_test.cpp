#include "scene/stand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/bounds.h"
#include "scene/copies.h"
#include "scene/scene.h"

namespace frond {
namespace {

/// A hundred years of a small wood in ten seconds.
const char* const kText = R"({
  "seed": 5, "film": {"frames": 240, "fps": 24, "size": [160, 90], "quality": "draft"},
  "scene": {"setting": "forest", "camera": {"location": [0, 3, 40], "look_at": [0, 4, 0]},
            "forest": {"terrain": {"size": 100, "hills": 2}}},
  "stand": {"area": [40, 40], "years": 100, "species": [{"name": "birch", "organism": "birch"},
            {"name": "beech", "organism": "beech"}, "spruce"]},
  "events": [{"year": 60, "storm": 1}, {"year": 30, "prune": {"entry": "birch", "below": 2}}],
  "organisms": [
    {"kind": "tree", "name": "birch", "count": 0, "sown": {"models": 2}, "coat": {"pattern": "banded"}},
    {"kind": "tree", "name": "beech", "count": 0, "sown": {"models": 3}},
    {"kind": "vase", "name": "shade plant", "count": 80,
     "sown": {"models": 1, "where": {"layer": "herbs", "radius": 0.2, "shade": [0.5, 1]}}}]})";

class Woodland : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    Result<Preset> preset = read_preset(kText, "test.json", {});
    ASSERT_TRUE(preset) << preset.errors().front().text();
    Result<Scene> built = build_scene(*preset);
    ASSERT_TRUE(built) << built.errors().front().text();
    scene = new Scene(std::move(*built));
    history = new StandHistory(stand_history(*preset, *scene->ground));
  }
  static void TearDownTestSuite() {
    delete scene;
    delete history;
  }
  /// Seconds of the film at a year.
  static double at(double year) { return year / 10; }

  /// Copies of trees that are there at a year, by their place: height, and whether they stand upright.
  struct Seen {
    double height = 0, crown = 0;
    bool upright = true;
    int copies = 0;
  };
  static std::map<std::pair<float, float>, Seen> seen(double year) {
    std::map<std::pair<float, float>, Seen> all;
    for (const CopySet& set : scene->copy_sets) {
      if (!set.organism.sown->size) continue;
      const Copies& c = set.copies;
      for (std::size_t i = 0; i < c.size(); ++i) {
        if (!c.there(i, at(year))) continue;
        Seen& one = all[{c.foot[i].x, c.foot[i].z}];
        one.height = c.scale_at(i, at(year)).y * set.organism.sown->size->height;
        one.crown = c.scale_at(i, at(year)).x * set.organism.sown->size->crown;
        one.upright = (c.turn_at(i, at(year)) * Vec3(0, 1, 0)).y > 0.99f;
        ++one.copies;
      }
    }
    return all;
  }

  /// Whether another tree stands at the place of a life at some time.
  static bool shared(const TreeLife& life) {
    return std::ranges::count_if(history->lives, [&](const TreeLife& other) {
             return other.x == life.x && other.z == life.z;
           }) > 1;
  }

  static Scene* scene;
  static StandHistory* history;
};
Scene* Woodland::scene = nullptr;
StandHistory* Woodland::history = nullptr;

TEST_F(Woodland, PrunedTreesHaveAnotherModel) {
  auto stand_at = [](const TreeLife& life, double year) {
    for (std::size_t k = 0; k < scene->copy_sets.size(); ++k) {
      const Copies& c = scene->copy_sets[k].copies;
      for (std::size_t i = 0; scene->copy_sets[k].organism.sown->size && i < c.size(); ++i)
        if (c.foot[i].x == life.x && c.foot[i].z == life.z && c.there(i, at(year)))
          return static_cast<int>(k);
    }
    return -1;
  };
  int changed[2]{}, tall[2]{};
  for (std::uint32_t i : living_at(*history, 30)) {
    const TreeLife& life = history->lives[i];
    if (life.species > 1 || life.died < 31 || size_at(*history, i, 30).height < 4) continue;
    ++tall[life.species], changed[life.species] += stand_at(life, 29.99) != stand_at(life, 30.01);
  }
  EXPECT_GT(tall[0], 0);
  EXPECT_EQ(changed[0], tall[0]);
  EXPECT_LE(changed[1], tall[1] / 4);
}

TEST_F(Woodland, ThePictureBrightensAsCrownsClose) {
  const Animated<double>& closed = *scene->setup.closed;
  EXPECT_LT(closed.at(at(1)), 0.05);
  EXPECT_GT(closed.at(at(50)), 0.15);  // the camera stands at the edge
  EXPECT_LE(closed.at(at(50)), 1.0);
}

TEST_F(Woodland, DrawsEachLivingTreeOnceAsLargeAsItIs) {
  EXPECT_TRUE(scene->find_fault().empty()) << scene->find_fault();
  int drawn = 0;
  for (double year : {12.3, 40.1, 77.7, 99.9}) {
    auto all = seen(year);
    for (std::uint32_t i : living_at(*history, year)) {
      const TreeLife& life = history->lives[i];
      if (shared(life)) continue;
      auto found = all.find({life.x, life.z});
      if (life.species == 2) {
        EXPECT_EQ(found, all.end()) << "the spruce is drawn as nothing";
        continue;
      }
      ASSERT_NE(found, all.end()) << i;
      EXPECT_EQ(found->second.copies, 1);
      EXPECT_TRUE(found->second.upright);
      TreeSize size = size_at(*history, i, year);
      EXPECT_NEAR(found->second.height, size.height, 0.2 * size.height + 0.25) << i << " in " << year;
      ++drawn;
    }
  }
  EXPECT_GT(drawn, 300);
}

TEST_F(Woodland, HasThePicturesOfItsBark) { EXPECT_FALSE(scene->drawings.empty()); }

TEST_F(Woodland, GrowsWithoutAJump) {
  constexpr double kStep = 0.05;  // years: a frame shows ten of them
  int followed = 0;
  auto before = seen(30);
  for (double year = 30 + kStep; year < 33; year += kStep) {
    auto now = seen(year);
    for (const auto& [place, one] : now) {
      auto old = before.find(place);
      if (old == before.end() || !one.upright || !old->second.upright) continue;
      EXPECT_NEAR(one.height, old->second.height, 0.02 * one.height + 0.05);
      EXPECT_NEAR(one.crown, old->second.crown, 0.03 * one.crown + 0.05);
      ++followed;
    }
    before = std::move(now);
  }
  EXPECT_GT(followed, 1000);
}

TEST_F(Woodland, DeadTreesFallAndRot) {
  int lie = 0, gone = 0;
  for (const TreeLife& life : history->lives) {
    if (life.species == 2 || life.died >= 80 || life.cause == DeathCause::cut || shared(life)) continue;
    double fallen = life.fell + 40;  // four seconds later
    if (fallen < std::min(life.rotted, 99.0f)) {
      auto all = seen(fallen);
      auto found = all.find({life.x, life.z});
      if (found != all.end() && found->second.copies == 1) {
        EXPECT_FALSE(found->second.upright);
        ++lie;
      }
    }
    if (life.rotted < 99) {
      EXPECT_FALSE(seen(life.rotted + 0.5).contains({life.x, life.z}));
      ++gone;
    }
  }
  EXPECT_GT(lie + gone, 5);
}

TEST_F(Woodland, WhatLikesShadeComesWithIt) {
  auto herbs = [&](double year) {
    int count = 0;
    for (const CopySet& set : scene->copy_sets) {
      if (set.organism.sown->size) continue;
      for (std::size_t i = 0; i < set.copies.size(); ++i) count += set.copies.there(i, at(year));
    }
    return count;
  };
  EXPECT_EQ(herbs(1), 0) << "on open land";
  EXPECT_GT(herbs(50), 5);
}

TEST_F(Woodland, IsOfModelsThatHaveGrownAboutAsTallAsTheyAreDrawn) {
  int compared = 0;
  for (const CopySet& set : scene->copy_sets) {
    Organism organism = set.organism;
    if (!organism.sown->size || organism.sown->size->height > 4) continue;
    double drawn = organism.sown->size->height;
    organism.sown->size.reset();
    Result<Model> model = grow_copy(organism, 0);
    ASSERT_TRUE(model);
    double grown = bounds_of(model->skeleton.position).high.y;
    EXPECT_LT(grown, 2.5 * drawn) << organism.name;
    EXPECT_GT(grown, drawn / 2.5) << organism.name;
    ++compared;
  }
  EXPECT_GE(compared, 8);
}

}  // namespace
}  // namespace frond
