#include "appearance/season.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "organisms/tree/tree.h"

namespace frond {
namespace {

TreeParams maple() {
  TreeParams params;
  params.years = 8;
  params.season = Seasons{};
  params.season->blossom = Blossom{};
  return params;
}

/// The tree's organs at a time of the year, on ground at height 0.
Model at(const TreeParams& params, double year) {
  Model model = grow_tree(params, Seed{3});
  Seasons seasons = *params.season;
  seasons.at = year;
  in_season(model, seasons, 0, Seed{1}, [](double, double) { return 0.0; });
  EXPECT_EQ(model.find_fault(), "");
  return model;
}

std::size_t count(const Model& model, std::size_t prototype) {
  return static_cast<std::size_t>(
      std::count(model.organs.prototype.begin(), model.organs.prototype.end(), prototype));
}

TEST(Season, NothingOfALeafJumps) {
  Seasons seasons;
  constexpr int kSteps = 20000;
  for (std::uint64_t leaf = 0; leaf < 20; ++leaf) {
    LeafState last = leaf_state(seasons, -1, Seed{leaf});
    for (int i = 1; i <= 3 * kSteps; ++i) {
      LeafState now = leaf_state(seasons, -1 + static_cast<double>(i) / kSteps, Seed{leaf});
      EXPECT_LT(std::abs(now.size - last.size), 0.003f);
      EXPECT_LT(std::abs(now.fallen - last.fallen), 0.004f + 2 * (now.size < 0.001f));
      EXPECT_LT(std::abs(now.hue - last.hue), 0.01f + 9 * (now.size < 0.001f));
      last = now;
    }
  }
}

TEST(Season, FallingOrganHasNoJumpInPlace) {
  TreeParams params = maple();
  params.season->blossom.reset();
  Model full = grow_tree(params, Seed{3});
  Organs& o = full.organs;
  // One leaf alone, so that it is known again.
  for (auto* list : {&o.birth}) list->resize(1);
  o.prototype.resize(1), o.position.resize(1), o.turn.resize(1), o.scale.resize(1);
  o.node.resize(1), o.color.resize(1), o.id.resize(1);
  o.position[0] = Vec3(1, 5, 0);
  params.season->litter = 1;
  Vec3 last(0);
  Quat turn(1, 0, 0, 0);
  bool there = false, landed = false;
  for (double year = 0.4; year < 1.2; year += 1e-4) {
    Organs now = o;
    Seasons seasons = *params.season;
    seasons.at = year;
    in_season(now, full.prototypes, seasons, 0, Seed{1}, [](double, double) { return 0.25; });
    if (now.size() == 0) continue;
    if (there) {
      EXPECT_LT(glm::distance(now.position[0], last), 0.12f) << "at " << year;
      EXPECT_GT(std::abs(glm::dot(now.turn[0], turn)), 0.98f) << "at " << year;
    }
    there = true, last = now.position[0], turn = now.turn[0];
    landed = landed || (now.loose[0] == 1 && std::abs(last.y - 0.262f) < 1e-3f);
  }
  EXPECT_TRUE(landed);
}

TEST(Season, SummerIsInFullLeafAndWinterBare) {
  TreeParams params = maple();
  Model full = grow_tree(params, Seed{3});
  Model summer = at(params, 0.55), winter = at(params, 1.1);
  EXPECT_EQ(count(summer, 0), full.organs.size());
  for (std::size_t i = 0; i < summer.organs.size(); ++i) {
    EXPECT_EQ(summer.organs.color[i], full.organs.color[i]);
    EXPECT_EQ(summer.organs.loose[i], 0);
  }
  EXPECT_EQ(count(summer, 1), 0u);
  std::size_t lying = count(winter, 0);
  EXPECT_GT(lying, full.organs.size() / 3);
  EXPECT_LT(lying, full.organs.size() * 4 / 5);
  for (std::size_t i = 0; i < winter.organs.size(); ++i) {
    EXPECT_EQ(winter.organs.loose[i], 1);
    EXPECT_LT(winter.organs.position[i].y, 0.05f);
  }
  params.season->litter = 0;
  EXPECT_EQ(at(params, 1.1).organs.size(), 0u);
}

TEST(Season, LeavesTurnOneByOne) {
  TreeParams params = maple();
  Model autumn = at(params, 0.8);
  auto green = static_cast<std::int32_t>(autumn.prototypes[0].summer);
  std::vector<std::int32_t> colors = autumn.organs.color;
  auto turned = std::count_if(colors.begin(), colors.end(), [&](std::int32_t c) { return c >= green; });
  EXPECT_GT(turned, static_cast<long>(colors.size()) / 5);
  EXPECT_LT(turned, static_cast<long>(colors.size()));
  std::sort(colors.begin(), colors.end());
  EXPECT_GT(std::unique(colors.begin(), colors.end()) - colors.begin(), 8);
  for (std::int32_t c : autumn.organs.color)
    EXPECT_LT(c, static_cast<std::int32_t>(autumn.prototypes[0].colors.size()));
  // In the last of its colours is what lies long.
  Model winter = at(params, 1.1);
  for (std::int32_t c : winter.organs.color)
    EXPECT_EQ(winter.prototypes[0].colors[static_cast<std::size_t>(c)], params.season->autumn.back());
}

TEST(Season, SpringBlooms) {
  TreeParams params = maple();
  EXPECT_GT(count(at(params, 0.3), 1), 100u);
  EXPECT_EQ(count(at(params, 0.5), 1), 0u);
}

TEST(Season, EvergreenStaysAsItIs) {
  TreeParams params = maple();
  params.season->evergreen = true, params.season->blossom.reset();
  Model full = grow_tree(params, Seed{3});
  for (double year : {0.1, 0.5, 0.9}) {
    Model now = at(params, year);
    EXPECT_EQ(now.organs.position, full.organs.position);
    EXPECT_EQ(now.organs.color, full.organs.color);
  }
}

TEST(Season, PicturesAreDrawnForAllSeasons) {
  TreeParams params = maple();
  params.leaves.picture = LeafLook{};
  params.leaves.picture->pixels = 16;
  Model model = grow_tree(params, Seed{3});
  std::vector<Drawing> drawn = leaf_drawings(pictured_leaves(params));
  const Prototype& leaf = model.prototypes[0];
  ASSERT_EQ(leaf.parts[0].pictures.size(), leaf.colors.size());
  ASSERT_EQ(drawn.size(), leaf.colors.size());
  for (std::size_t i = 0; i < leaf.colors.size(); ++i)
    EXPECT_EQ(drawn[i].names[0], leaf.parts[0].pictures[i]);
  EXPECT_EQ(leaf.colors.size(), 3u + 2 * 3 * 5 + 2 * 5);
}

}  // namespace
}  // namespace frond
