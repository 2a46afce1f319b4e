#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "masonry/block.h"
#include "scene/copies.h"

namespace frond {
namespace {

Organism sown_tree(const std::string& season) {
  std::string text =
      R"({"film": {"frames": 48}, "organisms": [{"kind": "tree", "years": 9, "sown": {"models": 2}, "season": )" +
      season + "}]}";
  Result<Preset> preset = read_preset(text, "test.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return preset->organisms.at(0);
}

const std::string kYear = R"("at": [[0, 0], [1, 1]])";

// Of its leaves, m2, at times of the year.
std::vector<double> leaf_areas(const Organism& o, double grain, int steps) {
  Film film{.frames = 48};
  Seasons seasons = *copy_seasons(o, film);
  Model full = *grow_copy(o, 0, true);
  full.skeleton = {};
  std::vector<double> areas;
  for (int i = 0; i <= steps; ++i) {
    Organs now = copy_organs(o, 0, full, seasons, static_cast<double>(i) / steps);
    double sum = 0;
    for (const CopyPart& part : copy_parts(o.grower->appearance().look, full, {grain, 1e9}, nullptr, &now))
      if (part.which == 0) sum += area(part.surface);
    areas.push_back(sum);
  }
  return areas;
}

TEST(CopySeasons, LeavesComeAndGoWithoutAJump) {
  Organism o = sown_tree("{" + kYear + "}");
  constexpr int kSteps = 60;
  for (double grain : {0.002, 0.05}) {
    std::vector<double> areas = leaf_areas(o, grain, kSteps);
    double most = *std::ranges::max_element(areas);
    ASSERT_GT(most, 0.1);
    EXPECT_EQ(areas[kSteps / 10], 0) << "it is bare in February";
    for (int i = 1; i <= kSteps; ++i) {
      double year = static_cast<double>(i) / kSteps, change = areas[i] - areas[i - 1];
      if (year < 0.6) {
        EXPECT_GE(change, -1e-6 * most) << year;
      } else if (year > 0.78) {
        EXPECT_LE(change, 1e-6 * most) << year;
      }
      EXPECT_LT(std::abs(change), 0.4 * most) << year;
    }
    EXPECT_NEAR(areas[kSteps / 2], most, 1e-4 * most);
    EXPECT_LT(areas[kSteps], 1e-3 * most);
  }
}

TEST(CopySeasons, FarLeavesStandForTheSameOnesAllYear) {
  Organism o = sown_tree("{" + kYear + "}");
  Model full = *grow_copy(o, 0, true);
  Seasons seasons = *copy_seasons(o, Film{.frames = 48});
  auto leaves = [&](const Organs* now) {
    std::vector<CopyPart> parts = copy_parts(o.grower->appearance().look, full, {0.05, 1e9}, nullptr, now);
    for (CopyPart& part : parts)
      if (part.kind == CopyPart::Kind::organ) return part.surface.position;
    return std::vector<Vec3>();
  };
  Organs summer = copy_organs(o, 0, full, seasons, 0.5);
  EXPECT_EQ(leaves(&summer), leaves(nullptr)) << "in summer all are there";
}

TEST(CopySeasons, AreNoneOfWhatStaysAsItIs) {
  Film film{.frames = 48}, still{.frames = 1};
  EXPECT_TRUE(copy_seasons(sown_tree("{" + kYear + "}"), film));
  EXPECT_FALSE(copy_seasons(sown_tree("{" + kYear + R"(, "evergreen": true})"), film));
  EXPECT_FALSE(copy_seasons(sown_tree("0.5"), film));
  EXPECT_FALSE(copy_seasons(sown_tree("{" + kYear + "}"), still));
}

TEST(CopySeasons, TheYearOfTheSceneIsThatOfSeasonsWithoutTheirOwn) {
  std::string text =
      R"({"film": {"frames": 48}, "scene": {"setting": "forest", "year": [[0, 0], [2, 1]]}, "organisms": [
      {"kind": "tree"}, {"kind": "tree", "season": {"fall": 0.8}}, {"kind": "tree", "season": 0.7}, {"kind": "rock"}]})";
  Result<Preset> preset = read_preset(text, "test.json", {});
  ASSERT_TRUE(preset) << preset.errors().front().text();
  auto at = [&](std::size_t i) { return preset->organisms[i].grower->appearance().season->at; };
  EXPECT_EQ(at(0).at(2), 1);
  EXPECT_EQ(at(1).at(2), 1);
  EXPECT_EQ(at(2).at(2), 0.7);
}

TEST(CopySeasons, FruitHangsOnCopiesFromNearAndFromAfar) {
  const std::string ripe =
      R"("evergreen": true, "fruit": {"share": 0.4, "ripe": [0.5, 0.55], "fall": [0.8, 0.85]}})";
  const Organism bearing = sown_tree(R"({"at": 0.7, )" + ripe), bare = sown_tree(R"({"at": 0.3, )" + ripe);
  const Look look = bearing.grower->appearance().look;
  auto areas = [&](const Organism& o, int level) {
    const Model model = *grow_copy(o, 0, false);
    double leaves = 0, fruit = 0;
    for (const CopyPart& part : copy_parts(look, model, kLevels[level]))
      if (part.kind == CopyPart::Kind::organ)
        (model.prototypes[part.which].name == kFruit ? fruit : leaves) += area(part.surface);
    return std::pair(leaves, fruit);
  };
  for (int level = 0; level < kLevelCount; ++level) {
    EXPECT_GT(areas(bearing, level).second, 0) << level;
    EXPECT_EQ(areas(bare, level).second, 0) << level;
  }
  EXPECT_TRUE(copy_seasons(sown_tree("{" + kYear + ", " + ripe), Film{.frames = 48}));
}

/// Cubic metres of the fruit of copies near the camera, as they are drawn, and as they are.
std::pair<double, double> fruit_volumes(const std::string& fruit, bool film) {
  const Organism o =
      sown_tree(R"({"at": 0.7, "evergreen": true, "fruit": {"ripe": [0.5, 0.55], "fall": [0.8, 0.85], )" +
                fruit + "}}");
  const Model full = *grow_copy(o, 0, film);
  const Organs organs = film ? copy_organs(o, 0, full, *o.grower->appearance().season, 0) : full.organs;
  double drawn = 0, is = 0;
  for (std::size_t i = 0; i < organs.size(); ++i) {
    const Prototype& shape = full.prototypes[organs.prototype[i]];
    const Vec3 sides = organs.scale[i];
    if (shape.name == kFruit)
      is += volume(shape.parts[0].surface) * static_cast<double>(sides.x * sides.y * sides.z);
  }
  const Look look = o.grower->appearance().look;
  for (const CopyPart& part : copy_parts(look, full, kLevels[0], nullptr, film ? &organs : nullptr))
    if (part.kind == CopyPart::Kind::organ && full.prototypes[part.which].name == kFruit)
      drawn += volume(part.surface);
  return {drawn, is};
}

TEST(CopySeasons, FruitOfNearCopiesIsABody) {
  for (bool film : {false, true}) {
    const auto [few, of_few] = fruit_volumes(R"("share": 0.02, "size": 0.08)", film);
    ASSERT_GT(of_few, 0);
    EXPECT_NEAR(few / of_few, 1, 0.01) << film;
    const auto [many, of_many] = fruit_volumes(R"("share": 0.6, "size": 0.08)", film);
    EXPECT_NEAR(many / of_many, 1, 0.35) << film;
  }
}

TEST(CopySeasons, WhatHasOneAndIsToGrowIsNoted) {
  auto notes = [](const std::string& more) {
    return build_scene(*read_preset(R"({"film": {"frames": 3}, "scene": {"setting": "forest"}, "organisms": [
        {"kind": "plant", "name": "herb", "count": 2, "growth": {"duration": 2}, "sown": {"models": 1},
         "grammar": {"axiom": "FF"})" + more +
                                        "}]}",
                                    "test.json", {}))
        ->notes;
  };
  const std::string said =
      "herb: its growth does nothing, since what is sown and has a season stands as it is";
  EXPECT_EQ(std::ranges::count(notes(""), said), 0);
  EXPECT_EQ(std::ranges::count(notes(R"(, "season": {"at": 0.5})"), said), 1);
}

}  // namespace
}  // namespace frond
