#include "appearance/health.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "appearance/condition.h"
#include "appearance/skin_colors.h"
#include "core/linear.h"
#include "organisms/tree/tree.h"

namespace frond {
namespace {

Health course(std::vector<Animated<double>::Key> keys) {
  Health health;
  health.at = Animated<double>(std::move(keys));
  return health;
}

float luminance(const Color& color) { return glm::dot(linear(color), Vec3(0.30f, 0.59f, 0.11f)); }

TEST(Health, RemembersTheWorst) {
  Health health = course({{0, 1}, {2, 0.3}, {6, 0.9}});
  float least = 1;
  for (double time = 0; time < 8; time += 0.05) {
    Fare fare = fare_at(health, time);
    EXPECT_LE(fare.least, least + 1e-6f) << time;
    EXPECT_LE(fare.least, fare.now) << time;
    EXPECT_NEAR(fare_at(health, time + 1.5, 1.5).now, fare.now, 1e-6) << "each moment by itself, only later";
    least = fare.least;
  }
  EXPECT_NEAR(fare_at(health, 8).now, 0.9, 1e-6);
  EXPECT_NEAR(least, 0.3, 1e-6);
}

TEST(CoralHealth, PalesAtHalfAndTurfComesBelow) {
  Health health;
  health.fluoresces = 1;
  auto at = [&](float now) { return bleached_at(health, {now, now}); };
  EXPECT_EQ(at(1).pale, 0);
  EXPECT_EQ(at(1).dead, 0);
  EXPECT_EQ(at(1).glow, 0);
  EXPECT_EQ(at(0.5f).pale, 1);
  EXPECT_EQ(at(0.5f).dead, 0);
  EXPECT_EQ(at(0).dead, 1);
  EXPECT_EQ(at(0).glow, 0);
  EXPECT_GT(at(0.85f).glow, 0.3f) << "just before it pales";
  EXPECT_LT(at(0.55f).glow, 0.05f);
  Skin skin;
  EXPECT_GT(luminance(skin_in(skin, at(0.5f)).tint.base), 1.5f * luminance(skin.tint.base)) << "white";
  EXPECT_LT(luminance(skin_in(skin, at(0)).tint.base), luminance(skin_in(skin, at(0.5f)).tint.base));
  EXPECT_NEAR(luminance(skin_in(skin, {}).tint.base), luminance(skin.tint.base), 1e-4f);
}

TEST(CoralHealth, WhatHasDiedStaysDead) {
  Health health;
  Material living{.matter = Matter::polyps};
  Condition condition{{health, {}}, Seed{1}};
  condition.courses.health->at = Animated<double>(std::vector<Animated<double>::Key>{{0, 1}, {2, 0}, {4, 1}});
  condition.turf = {{{Vec3(0), 0.1f}}};
  Material before = material_at(living, 0, condition, 0), after = material_at(living, 0, condition, 9);
  EXPECT_TRUE(before.dead.empty());
  EXPECT_EQ(after.dead.size(), 1u);
  EXPECT_NEAR(after.dead[0].radius, 0.1f, 1e-5f);
  condition.courses.health->at =
      Animated<double>(std::vector<Animated<double>::Key>{{0, 1}, {2, 0.5}, {4, 1}});
  Material healed = material_at(living, 0, condition, 9);
  EXPECT_TRUE(healed.dead.empty());
  EXPECT_NEAR(luminance(healed.color), luminance(living.color), 1e-4f) << "one that was only white recovers";
  Material stone{.matter = Matter::granite};
  EXPECT_EQ(material_in(stone, {1, 1, 1}).color.red, stone.color.red);
}

TEST(CoralHealth, TurfCoversAllOfASkin) {
  Surface skin;
  for (int i = 0; i < 400; ++i) {
    auto turn = static_cast<float>(i) * 2.4f, up = 1 - static_cast<float>(i) / 200;
    skin.position.push_back(
        0.2f * Vec3(std::sqrt(1 - up * up) * std::cos(turn), up, std::sqrt(1 - up * up) * std::sin(turn)));
  }
  std::size_t covered = 0;
  std::vector<DeadPatch> turf = turf_at({}, turf_on(skin, Seed{3}), 1);
  for (const Vec3& p : skin.position)
    covered +=
        std::ranges::any_of(turf, [&](const DeadPatch& t) { return glm::distance(p, t.at) < t.radius; });
  EXPECT_GT(covered, 380u);
  EXPECT_TRUE(turf_at({}, turf_on(skin, Seed{3}), 0).empty());
}

/// A young tree with single leaves that have the colours of failing health.
struct Ailing {
  Model model;
  Health health;

  Ailing() {
    TreeParams params;
    params.years = 6;
    params.leaves.picture.emplace();
    model = grow_tree(params, Seed{3});
    Look look;
    look.leaves = pictured_leaves(params);
    health.at = 0.5;
    add_ailing(model, look, {health, {}});
  }

  Model at(Fare fare) const {
    Model now = model;
    ail(now.organs, now.prototypes, health, fare, Seed{5}, [](double, double) { return 0.0; });
    EXPECT_EQ(now.find_fault(), "");
    return now;
  }
  /// The mean share of red light in the leaves' colours against green.
  static float redness(const Model& model) {
    float sum = 0;
    for (std::size_t i = 0; i < model.organs.size(); ++i) {
      const Prototype& leaf = model.prototypes[model.organs.prototype[i]];
      Vec3 c = linear(leaf.colors[color_index(model.organs.color[i], leaf.colors.size())]);
      sum += c.x / c.y;
    }
    return sum / static_cast<float>(model.organs.size());
  }
};

TEST(LeafHealth, LeavesTurnFromTheOldestOn) {
  Ailing tree;
  ASSERT_GT(tree.model.organs.size(), 20u);
  float last = Ailing::redness(tree.at({1, 1}));
  for (float now : {0.85f, 0.7f, 0.55f, 0.4f}) {
    float redness = Ailing::redness(tree.at({now, now}));
    EXPECT_GT(redness, last) << now;
    last = redness;
  }
  EXPECT_EQ(tree.at({0, 0}).organs.size(), tree.model.organs.size()) << "none falls unless it is said";
}

TEST(LeafHealth, YellowLeavesGreenAgainAndDryOnesDoNot) {
  Ailing tree;
  float green = Ailing::redness(tree.at({1, 1}));
  EXPECT_FLOAT_EQ(Ailing::redness(tree.at({1, 0.85f})), green);
  EXPECT_GT(Ailing::redness(tree.at({1, 0})), 1.2f * green);
}

TEST(LeafHealth, LeavesHangAndFall) {
  Ailing tree;
  auto down = [](const Model& model) {
    float sum = 0;
    for (const Quat& turn : model.organs.turn) sum -= (turn * Vec3(0, 1, 0)).y;
    return sum / static_cast<float>(model.organs.size());
  };
  EXPECT_GT(down(tree.at({0, 0})), down(tree.at({1, 1})) + 0.3f);
  tree.health.sheds = 0.3;
  EXPECT_EQ(tree.at({0.31f, 0.31f}).organs.size(), tree.model.organs.size());
  Model bare = tree.at({0, 0});
  EXPECT_LT(bare.organs.size(), tree.model.organs.size());
  for (std::size_t i = 0; i < bare.organs.size(); ++i) EXPECT_LT(bare.organs.position[i].y, 0.1f) << i;
}

TEST(LeafHealth, NothingJumps) {
  Ailing tree;
  tree.health.sheds = 0.3;
  // While none is gone, each organ is the one of before.
  Model last = tree.at({1, 1});
  for (float now = 0.9995f; now > 0; now -= 0.0005f) {
    Model next = tree.at({now, now});
    if (next.organs.size() != last.organs.size()) break;
    for (std::size_t i = 0; i < next.organs.size(); ++i) {
      EXPECT_LT(glm::distance(next.organs.position[i], last.organs.position[i]), 0.15f) << now;
      EXPECT_LT(glm::distance(next.organs.scale[i], last.organs.scale[i]),
                0.1f * glm::length(tree.model.organs.scale[i]))
          << now;
    }
    last = std::move(next);
  }
}

TEST(LeafHealth, CopiesKeepTheNumberOfTheirColours) {
  Ailing tree;
  for (Prototype leaf : tree.model.prototypes) {
    if (leaf.ailing == 0) continue;
    std::size_t own = leaf.ailing;
    std::vector<std::string> pictures = leaf.parts[0].pictures;
    fade(leaf, tree.health, {0.1f, 0.1f}, true);
    EXPECT_EQ(leaf.colors.size(), own);
    EXPECT_EQ(leaf.parts[0].pictures.size(), own);
    EXPECT_NE(leaf.parts[0].pictures[0], pictures[0]);
  }
}

TEST(Condition, IsNoneWhereNothingChanges) {
  Look look;
  EXPECT_FALSE(condition_of({}, look, {}));
  Health whole;
  EXPECT_FALSE(condition_of({whole, ColorCourse{}}, look, {}));
  whole.at = 0.9;
  EXPECT_TRUE(condition_of({whole, {}}, look, {}));
  EXPECT_TRUE(condition_of({{}, ColorCourse{.hue = 10.0}}, look, {}));
  look.branches.skin.emplace().tint.course.value =
      Animated<double>(std::vector<Animated<double>::Key>{{0, 1}, {1, 0.5}});
  EXPECT_TRUE(condition_of({}, look, {}));
}

TEST(Condition, ColoursFollowTheirKeyframes) {
  Look look;
  look.branches.skin.emplace();
  ColorCourse course;
  course.saturation = Animated<double>(std::vector<Animated<double>::Key>{{0, 1}, {4, 0}});
  Condition condition{{{}, course}, Seed{1}};
  Vec3 begin = old_skin(*look_at(look, condition, 0).branches.skin).tissue,
       end = old_skin(*look_at(look, condition, 4).branches.skin).tissue;
  EXPECT_NEAR(glm::distance(begin, old_skin(*look.branches.skin).tissue), 0, 1e-3f);
  EXPECT_NEAR(end.x, end.y, 2e-3f);
  EXPECT_NEAR(end.y, end.z, 2e-3f);
  EXPECT_GT(begin.x - begin.z, 0.05f);
}

}  // namespace
}  // namespace frond
