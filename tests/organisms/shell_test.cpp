#include "organisms/shell/shell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "appearance/shell_pigment.h"
#include "core/parallel.h"
#include "organisms/shell/coil.h"
#include "solidity.h"
#include "solids.h"

namespace frond {
namespace {

ShellParams snail() {
  ShellParams params;
  params.detail = 16000;
  params.ribs = {.count = 8, .height = 0.02};
  params.costae = {.count = 9, .height = 0.03};
  return params;
}

ShellParams clam() {
  ShellParams params;
  params.form = ShellForm::bivalve;
  params.expansion = 120, params.distance = 0.02, params.aspect = 1.4, params.whorls = 0.42;
  params.ribs = {.count = 7, .height = 0.1};
  params.scutes = {.count = 6, .height = 0.05};
  params.translation = 0;
  params.detail = 16000;
  params.mantle = MantleParams{};
  return params;
}

const Surface& skin(const Model& model, std::size_t shape = 0) {
  return model.solids.shapes.at(shape).surface;
}

float reach_of(const Surface& s) {
  float most = 0;
  for (Vec3 p : s.position) most = std::max(most, glm::length(p));
  return most;
}

TEST(Shell, IsAClosedBodyTurnedOutward) {
  for (const ShellParams& params : {snail(), clam()})
    for (double share : {0.02, 0.4, 1.0}) {
      Model model = grow_shell(params, share, 0.3, Seed{1});
      EXPECT_EQ(model.find_fault(), "");
      for (const Solid& solid : model.solids.shapes) {
        EXPECT_GT(volume(solid.surface), 0);
        if (share == 1) {
          EXPECT_EQ(solidity(solid.surface).open, 0u);
        }
      }
    }
}

/// Raup: in a whorl all of it grows by one factor, and no other.
TEST(Shell, IsItselfAWhorlBeforeButSmaller) {
  ShellParams params = snail();
  params.ribs = {}, params.costae = {};
  ShellEdge edge = shell_edge(params);
  float before = reach_of(shell_wall(params, edge, 2 * kPi, false)),
        now = reach_of(shell_wall(params, edge, 0, false));
  EXPECT_NEAR(now / before, params.expansion, 0.01 * params.expansion);
}

TEST(Shell, IsAsLargeAsItIsToBe) {
  for (const ShellParams& params : {snail(), clam()}) {
    Vec3 low(1e9f), high(-1e9f);
    Surface shell = skin(grow_shell(params, 1, 0, Seed{1}));
    for (Vec3 p : shell.position) low = glm::min(low, p), high = glm::max(high, p);
    Vec3 wide = high - low;
    EXPECT_NEAR(std::max({wide.x, wide.y, wide.z}), params.size, 1e-6);
    EXPECT_NEAR(low.y, 0, 1e-6);
  }
}

TEST(Shell, ValvesMeetInOneMarginAndDoNotCross) {
  ShellParams params = clam();
  ShellEdge edge = shell_edge(params);
  for (double grown : {0.0, 0.5})
    for (const ShellEdge::At& at : edge.at) {
      Vec3 up = shell_margin(params, edge, at, grown, false),
           down = shell_margin(params, edge, at, grown, true);
      EXPECT_LT(glm::distance(up, down), 1e-5f);
      EXPECT_NEAR(up.y, -params.ribs.height * at.crest * std::exp(-params.rate() * grown), 1e-5);
    }
  // What is off the margin lies above that of the other valve.
  params.ribs.height = 0;
  edge = shell_edge(params);
  Surface over = shell_wall(params, edge, 0, false);
  for (Vec3 p : over.position) EXPECT_GE(p.y, -1e-6f);
  Surface under = shell_wall(params, edge, 0, true);
  for (Vec3 p : under.position) EXPECT_LE(p.y, 1e-6f);
}

TEST(Shell, ValvesTurnRoundOneHinge) {
  ShellParams params = clam();
  params.mantle.reset();
  Surface shut = skin(grow_shell(params, 1, 0, Seed{1})), open = skin(grow_shell(params, 1, 0.5, Seed{1}));
  ASSERT_EQ(shut.position.size(), open.position.size());
  std::size_t valve = shut.position.size() / 2;
  // Both valves are rigid, and a place near the hinge hardly moves, that of the margin far away does.
  double least = 1e9, most = 0;
  for (std::size_t i = 0; i < shut.position.size(); ++i) {
    std::size_t first = i < valve ? 0 : valve;
    EXPECT_NEAR(glm::distance(shut.position[i], shut.position[first]),
                glm::distance(open.position[i], open.position[first]), 2e-6);
    double moved = glm::distance(shut.position[i], open.position[i]);
    least = std::min(least, moved), most = std::max(most, moved);
  }
  EXPECT_LT(least, 0.05 * most);
}

TEST(Shell, GrowsWithoutAJumpAndNeverShrinks) {
  for (const ShellParams& params : {snail(), clam()}) {
    double last = 0;
    Surface before;
    for (int k = 0; k <= 60; ++k) {
      Surface now = skin(grow_shell(params, k / 60.0, 0, Seed{1}));
      double held = volume(now);
      EXPECT_GE(held, last * (1 - 1e-6)) << k;
      last = held;
      if (k > 0) {
        float most = 0;
        for (std::size_t i = 0; i < now.position.size(); ++i)
          most = std::max(most, glm::distance(now.position[i], before.position[i]));
        EXPECT_LT(most, 0.15 * params.size) << k;
      }
      before = std::move(now);
    }
  }
}

TEST(Shell, PigmentIsTheSameOnOneThreadAndOnTwo) {
  for (ShellPattern regime : {ShellPattern::stripes, ShellPattern::axial, ShellPattern::zigzag,
                              ShellPattern::tents, ShellPattern::spots}) {
    limit_threads(1);
    Grid one = pigment(regime, 128, 256, Seed{3});
    limit_threads(2);
    Grid two = pigment(regime, 128, 256, Seed{3});
    EXPECT_EQ(one.data, two.data);
    auto [least, most] = std::ranges::minmax_element(one.data);
    EXPECT_LT(*least, 0.3f);
    EXPECT_GT(*most, 0.7f);
    EXPECT_NE(pigment(regime, 128, 256, Seed{4}).data, one.data);
  }
  limit_threads(0);
}

/// Stripes go on from line to line, waves do not.
TEST(Shell, RegimesDifferInWhichWayLinesRun) {
  auto along = [](ShellPattern regime) {
    Grid grid = pigment(regime, 128, 256, Seed{3});
    double same = 0, across = 0;
    for (int y = 0; y + 12 < grid.height; ++y)
      for (int x = 0; x + 12 < grid.width; ++x) {
        same += std::abs(grid.at(x, y) - grid.at(x, y + 12));
        across += std::abs(grid.at(x, y) - grid.at(x + 12, y));
      }
    return same / across;
  };
  EXPECT_LT(along(ShellPattern::stripes), 0.3);
  EXPECT_GT(along(ShellPattern::axial), 1.5);
}

}  // namespace
}  // namespace frond
