#include "appearance/fruiting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "appearance/season.h"
#include "core/bounds.h"
#include "organisms/tree/tree.h"

namespace frond {
namespace {

TreeParams apple() {
  TreeParams params;
  params.years = 8;
  params.season = Seasons{};
  params.season->fruit = Fruiting{};
  return params;
}

double level(double, double) { return 0; }

/// The fruit of a tree at a time of the year.
struct Crop {
  std::vector<double> sizes, heights;
  std::vector<Vec3> axes;  ///< from the stalk to the tip
  std::vector<std::int32_t> colors;
  std::size_t free = 0;  ///< how many hang no longer

  double mean() const {
    double sum = 0;
    for (double size : sizes) sum += size;
    return sizes.empty() ? 0 : sum / static_cast<double>(sizes.size());
  }
};

Crop crop_at(const TreeParams& params, const Model& full, double year, const GroundAt& ground = level) {
  Model model = full;
  Seasons seasons = *params.season;
  seasons.at = year;
  in_season(model, seasons, 0, Seed{1}, ground);
  EXPECT_EQ(model.find_fault(), "");
  Crop crop;
  const Organs& o = model.organs;
  for (std::size_t i = 0; i < o.size(); ++i) {
    if (model.prototypes[o.prototype[i]].name != kFruit) continue;
    crop.sizes.push_back(static_cast<double>(o.scale[i].y));
    crop.heights.push_back(static_cast<double>(o.position[i].y));
    crop.axes.push_back(o.turn[i] * Vec3(0, 1, 0));
    crop.colors.push_back(o.color[i]);
    crop.free += o.loose[i] > 0;
  }
  return crop;
}

TEST(Fruiting, GrowsInNumberAndSizeUntilItIsRipe) {
  const TreeParams params = apple();
  const Fruiting& fruit = *params.season->fruit;
  const Model full = grow_tree(params, Seed{3});
  std::size_t count = 0;
  double mean = 0;
  for (double year = 0.35; year <= static_cast<double>(fruit.fall.x); year += 0.01) {
    const Crop now = crop_at(params, full, year);
    EXPECT_GE(now.sizes.size(), count) << "at " << year;
    // While more set, the mean may fall; the sum does not.
    EXPECT_GE(now.mean() * static_cast<double>(now.sizes.size()), mean - 1e-9) << "at " << year;
    count = now.sizes.size(), mean = now.mean() * static_cast<double>(count);
    for (double size : now.sizes) EXPECT_LE(size, fruit.size * (1 + fruit.size_variation));
  }
  EXPECT_GT(count, 100u);
  const Crop ripe = crop_at(params, full, static_cast<double>(fruit.ripe.y));
  EXPECT_NEAR(ripe.mean(), fruit.size, 0.05 * fruit.size);
  EXPECT_LE(*std::ranges::max_element(ripe.colors), 4) << "of two colours with three between";
}

TEST(Fruiting, EachSwellsWithoutAJumpAndNeverShrinks) {
  const Fruiting fruit;
  for (std::uint64_t k = 0; k < 50; ++k) {
    FruitState last = fruit_state(fruit, 0, 0.02, Seed{k});
    for (double age = 0; age < 1.2; age += 1e-4) {
      const FruitState now = fruit_state(fruit, age, 0.02, Seed{k});
      EXPECT_GE(now.size, last.size);
      EXPECT_LT(now.size - last.size, 0.002);
      EXPECT_GE(now.ripe, last.ripe);
      EXPECT_GE(now.fallen, last.fallen);
      last = now;
    }
    EXPECT_EQ(last.lain, 1);
  }
}

TEST(Fruiting, IsNotThereBeforeItSetsNorAfterItHasGone) {
  TreeParams params = apple();
  const Fruiting& fruit = *params.season->fruit;
  const Model full = grow_tree(params, Seed{3});
  const double drift = params.season->drift, last = static_cast<double>(fruit.fall.y) + drift;
  EXPECT_TRUE(crop_at(params, full, static_cast<double>(fruit.set.x)).sizes.empty());
  EXPECT_EQ(crop_at(params, full, static_cast<double>(fruit.fall.x)).free, 0u);
  const Crop lying = crop_at(params, full, last + 0.3 * fruit.lies);
  EXPECT_EQ(lying.free, lying.sizes.size());
  EXPECT_GT(lying.free, 20u);
  for (double high : lying.heights) EXPECT_NEAR(high, fruit.size / 2, fruit.size / 4) << "on the ground";
  EXPECT_TRUE(crop_at(params, full, last + fruit.lies + 1e-6).sizes.empty());
  EXPECT_TRUE(crop_at(params, full, last + 1e-6, {}).sizes.empty()) << "where no ground is known";
}

TEST(Fruiting, HangsDownWithinItsAngleOnceItIsRipe) {
  TreeParams params = apple();
  Fruiting& fruit = *params.season->fruit;
  const Model full = grow_tree(params, Seed{3});
  auto steepest = [&](double year) {
    double most = 0;
    for (const Vec3& axis : crop_at(params, full, year).axes)
      most = std::max(most, std::acos(std::clamp(-static_cast<double>(axis.y), -1.0, 1.0)));
    return most;
  };
  const auto ripe = static_cast<double>(fruit.ripe.y);
  EXPECT_LE(steepest(ripe), fruit.angle + 1e-3);
  EXPECT_GT(steepest(0.41), radians(60.0)) << "small fruit still stands as its flower did";
  // Two that hang from one place hang as far apart as they are wide.
  fruit.cluster = 2, fruit.angle = 0, fruit.size_variation = 0;
  const double far = fruit.stalk + fruit.size / 2;
  EXPECT_NEAR(steepest(ripe), std::asin(fruit.size / 2 / far), 1e-3);
}

TEST(Fruiting, OfManyInAClusterLeavesRoomForEach) {
  Fruiting fruit;
  fruit.cluster = 40, fruit.size = 0.009, fruit.stalk = 0.03;
  double sum = 0;
  int pairs = 0;
  for (int a = 0; a < fruit.cluster; ++a) {
    double nearest = 1;
    for (int b = 0; b < fruit.cluster; ++b) {
      if (a == b) continue;
      const Vec3 between = fruit_direction(fruit, a, 1, Vec3(0, 1, 0), Seed{4}) -
                           fruit_direction(fruit, b, 1, Vec3(0, 1, 0), Seed{4});
      nearest = std::min(nearest, static_cast<double>(glm::length(between)) * (fruit.stalk + fruit.size / 2));
    }
    sum += nearest, ++pairs;
  }
  EXPECT_GT(sum / pairs, 0.75 * fruit.size);
}

TEST(Fruiting, OfTwoYearsHangsTogetherWhereItRipensInTheNext) {
  TreeParams params = apple();
  Fruiting& fruit = *params.season->fruit;
  fruit.ripe = {1.1f, 1.2f}, fruit.fall = {1.5f, 1.6f};
  const Model full = grow_tree(params, Seed{3});
  const std::size_t one = crop_at(params, full, 0.34).sizes.size();
  EXPECT_GT(one, 100u);
  const Crop both = crop_at(params, full, 0.48);
  EXPECT_EQ(both.sizes.size(), 2 * one);
  EXPECT_LT(*std::ranges::min_element(both.sizes), 0.75 * *std::ranges::max_element(both.sizes));
}

TEST(Fruiting, IsTheSameEachTimeAndOtherInAnotherYear) {
  const TreeParams params = apple();
  const Model full = grow_tree(params, Seed{3});
  const Crop one = crop_at(params, full, 0.7), again = crop_at(params, full, 0.7),
             next = crop_at(params, full, 1.7);
  EXPECT_EQ(one.sizes, again.sizes);
  EXPECT_EQ(one.axes, again.axes);
  EXPECT_EQ(one.colors, again.colors);
  EXPECT_EQ(one.sizes.size(), next.sizes.size()) << "the same places bear";
  EXPECT_NE(one.sizes, next.sizes);
}

TEST(Fruiting, BearsWhereTheFlowersWere) {
  TreeParams params = apple();
  params.season->blossom = Blossom{.share = 0.3, .lasts = 0.2};
  params.season->fruit->share = 0.2;
  const Model full = grow_tree(params, Seed{3});
  Model spring = full;
  Seasons seasons = *params.season;
  seasons.at = 0.36;  // all are open, and none has fallen
  in_season(spring, seasons, 0, Seed{1}, level);
  const std::vector<Vec3> fruit = [&] {
    std::vector<Vec3> places;
    Model summer = full;
    seasons.at = 0.6;
    seasons.fruit->stalk = 0;
    in_season(summer, seasons, 0, Seed{1}, level);
    for (std::size_t i = 0; i < summer.organs.size(); ++i)
      if (summer.prototypes[summer.organs.prototype[i]].name == kFruit)
        places.push_back(summer.organs.position[i]);
    return places;
  }();
  std::vector<Vec3> flowers;
  for (std::size_t i = 0; i < spring.organs.size(); ++i)
    if (spring.prototypes[spring.organs.prototype[i]].name == "blossom")
      flowers.push_back(spring.organs.position[i]);
  ASSERT_FALSE(fruit.empty());
  for (const Vec3& at : fruit)
    EXPECT_TRUE(
        std::ranges::any_of(flowers, [&](const Vec3& flower) { return glm::distance(at, flower) < 0.05f; }));
}

TEST(Fruiting, TurnsItsBlushOutOfTheCrown) {
  for (int k = 0; k < 12; ++k) {
    const Vec3 light = glm::normalize(Vec3(std::cos(k), 0.3, std::sin(k)));
    const Vec3 down = glm::normalize(Vec3(0.2, -1, 0.1));
    const Quat turn = fruit_turn(down, light);
    EXPECT_NEAR(glm::distance(turn * Vec3(0, 1, 0), down), 0, 1e-5);
    EXPECT_GT(glm::dot(turn * Vec3(0, 0, 1), light), 0.8f);
  }
}

TEST(Fruiting, WearsAPictureForEachOfItsColoursWhereItHasABlush) {
  Fruiting fruit;
  fruit.colors = {{0.5f, 0.6f, 0.2f}, {0.85f, 0.75f, 0.3f}};
  std::vector<Prototype> plain, blushing;
  add_fruit(plain, fruit);
  EXPECT_TRUE(plain[0].parts[0].pictures.empty());
  fruit.blush = Color{0.7f, 0.1f, 0.1f};
  add_fruit(blushing, fruit);
  const std::vector<Drawing> drawn = fruit_drawings(fruit);
  ASSERT_EQ(drawn.size(), blushing[0].colors.size());
  for (std::size_t i = 0; i < drawn.size(); ++i)
    EXPECT_EQ(drawn[i].names[0], blushing[0].parts[0].pictures[i]);
  // The right half of the ripe one's picture looks toward the light, and has less green in it.
  Result<std::vector<Picture>> ripe = drawn[4].draw();
  ASSERT_TRUE(ripe);
  Result<Raster> skin = read_png((*ripe)[0].bytes);
  ASSERT_TRUE(skin);
  double shade = 0, light = 0;
  for (int y = 8; y < skin->height - 8; ++y)
    for (int x = 0; x < skin->width / 4; ++x)
      shade += skin->at(x, y, 1), light += skin->at(skin->width - 1 - x, y, 1);
  EXPECT_GT(shade, 1.5 * light);
}

TEST(Fruiting, GoesOnFromItsColourWhereItLies) {
  const Fruiting fruit;
  for (double ripe : {0.5, 0.8, 1.0}) {
    FruitState state{.size = 1, .ripe = ripe, .fallen = 1};
    std::int32_t before = fruit_color(fruit, state);
    for (int k = 1; k <= 100; ++k) {
      state.lain = k / 100.0;
      const std::int32_t now = fruit_color(fruit, state);
      EXPECT_TRUE(now == before || now == before + 1) << ripe << ' ' << state.lain;
      before = now;
    }
    EXPECT_EQ(before, 7) << "rot, at the end";
  }
}

/// A form is closed, of its length and width, and has a place on its picture everywhere.
TEST(FruitShapes, AreOfTheirSize) {
  for (FruitForm form : {FruitForm::round, FruitForm::drop, FruitForm::pod, FruitForm::winged,
                         FruitForm::cone, FruitForm::spiny, FruitForm::acorn}) {
    for (double width : {0.4, 1.0}) {
      const FruitParts parts = fruit_parts(form, width);
      EXPECT_EQ(parts.body.find_fault(), "");
      EXPECT_EQ(parts.body.uv.size(), parts.body.position.size());
      Bounds box = bounds_of(parts.body.position);
      if (!parts.cup.position.empty()) {
        EXPECT_EQ(parts.cup.find_fault(), "");
        for (const Vec3& p : parts.cup.position) box.extend(p);
      }
      const auto number = static_cast<int>(form);
      EXPECT_NEAR(box.size().y, 1, 0.08) << number;
      if (form != FruitForm::winged) {
        EXPECT_NEAR(box.size().x, width, 0.16 * width) << number;
      }
      for (const Vec2& uv : parts.body.uv) EXPECT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1);
    }
  }
}

}  // namespace
}  // namespace frond
