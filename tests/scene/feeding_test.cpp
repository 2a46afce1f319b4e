#include <gtest/gtest.h>

#include "scene/scene.h"
#include "world/world.h"

namespace frond {
namespace {

/// Two corals side by side that share food; one place is far from both.
Scene hungry_pair(const std::string& eaten) {
  Result<Preset> preset = read_preset(
      R"j({"seed": 2, "film": {"frames": 48, "fps": 12}, "scene": {"setting": "underwater"},
      "defaults": {"food": {"strength": 20, "eaten": )j" +
          eaten +
          R"j(, "position": [[0, [3, 0.4, 0]], [4, [-3, 0.4, 0]]], "others": [{"position": [0, 9, 0]}]}},
      "organisms": [{"kind": "coral", "steps": 3, "height": 0.5, "count": 2,
        "place": {"at": [[-0.6, 0], [0.6, 0]], "rock": 0}, "growth": {"duration": 0.5}}]})j",
      "feeding.json", {});
  EXPECT_TRUE(preset) << preset.errors()[0].text();
  return std::move(*build_scene(*preset));
}

TEST(Feeding, WhatATipReachesIsEatenByWhoComesFirst) {
  Scene scene = hungry_pair("true");
  const Food &left = scene.specimens[0].motion.food, &right = scene.specimens[1].motion.food;
  ASSERT_EQ(left.reached.size(), 2u);
  EXPECT_EQ(left.reached, right.reached) << "it is the same food";
  // It comes by the one to the right first.
  EXPECT_GT(left.reached[0], 0.8);
  EXPECT_LT(left.reached[0], 2.2);
  EXPECT_GT(left.reached[1], 4) << "nobody comes so high";
  EXPECT_EQ(food_places(scene.specimens, 0.1).size(), 2u);
  EXPECT_EQ(food_places(scene.specimens, left.reached[0] + kMeal + 0.01).size(), 1u);
  float before = left.left(0, left.reached[0] + 0.4 * kMeal),
        after = left.left(0, left.reached[0] + 0.6 * kMeal);
  EXPECT_GT(before, after);
  EXPECT_GT(after, 0);
}

TEST(Feeding, OtherwiseFoodStays) {
  Scene scene = hungry_pair("false");
  EXPECT_TRUE(scene.specimens[0].motion.food.reached.empty());
  EXPECT_EQ(food_places(scene.specimens, 3.9).size(), 2u);
}

}  // namespace
}  // namespace frond
