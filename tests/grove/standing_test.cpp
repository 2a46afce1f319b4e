#include "grove/standing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

constexpr int kYears = 16;

const GrownTree& film_tree() {
  static const GrownTree tree = [] {
    Seedling s;
    s.seed = Seed{8};
    GroveOptions options;
    options.years = kYears;
    options.history = true;
    return grow_grove({s}, options)[0];
  }();
  return tree;
}

Standing at(double year) { return standing(film_tree(), Species{}, year, {0.5, 1.2}); }

TEST(Standing, GrowsFromNothingToTheWholeTree) {
  EXPECT_LE(at(0).size(), 1u);
  Standing end = at(kYears + 0.5);
  std::size_t stands = 0, found = 0;
  for (std::size_t i = 0; i < film_tree().size(); ++i) stands += film_tree().fell[i] == GrownTree::kNever;
  for (std::size_t k = 0; k < end.size(); ++k) {
    std::uint32_t i = end.source[k];
    if (film_tree().fell[i] != GrownTree::kNever) continue;
    ++found;
    EXPECT_EQ(end.tip[k], film_tree().tip[i]);
    EXPECT_FLOAT_EQ(end.radius[k], i == 0 ? end.radius[k] : film_tree().radius[i]);
  }
  EXPECT_EQ(found, stands);
}

/// From one moment to the next nothing appears but as a point, nothing jumps, nothing goes but thin.
TEST(Standing, NothingPops) {
  constexpr double kStep = 0.01;  // years; 5 ms of film
  for (double year : {2.97, 5.0, 7.42, 9.99, 12.3, 15.0}) {
    for (int k = 0; k < 5; ++k) {
      Standing a = at(year + k * kStep), b = at(year + (k + 1) * kStep);
      std::vector<int> seen(film_tree().size(), -1);
      for (std::size_t i = 0; i < a.size(); ++i) seen[a.source[i]] = static_cast<int>(i);
      for (std::size_t i = 0; i < b.size(); ++i) {
        int was = seen[b.source[i]];
        if (was < 0) {
          EXPECT_LT(glm::distance(b.tip[i], b.foot[i]), 0.03f) << "a shoot begins short";
          EXPECT_LT(b.radius[i], 0.004f) << "and thin";
          EXPECT_LT(b.leaves[i], 0.02f);
          continue;
        }
        seen[b.source[i]] = -1;
        EXPECT_LT(glm::distance(a.tip[was], b.tip[i]), 0.12f) << "year " << year;
        EXPECT_LT(std::abs(a.radius[was] - b.radius[i]), 0.002f + 0.02f * a.radius[was]);
        EXPECT_LT(std::abs(a.leaves[was] - b.leaves[i]), 0.06f);
      }
      for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i] >= 0) {
          EXPECT_LT(a.radius[static_cast<std::size_t>(seen[i])], 0.002f) << "what goes has shrunk away";
        }
    }
  }
}

TEST(Standing, WoodGrowsEvenlyByArea) {
  const GrownTree& t = film_tree();
  std::size_t trunk = 1;
  auto area = [&](double year) {
    Standing now = at(year);
    for (std::size_t i = 0; i < now.size(); ++i)
      if (now.source[i] == trunk) return static_cast<double>(now.radius[i] * now.radius[i]);
    return 0.0;
  };
  for (int year : {4, 9, 14}) {
    EXPECT_NEAR(area(year + 0.5), (area(year) + area(year + 1)) / 2, 1e-7);
    EXPECT_NEAR(area(year + 0.25), area(year) + (area(year + 1) - area(year)) / 4, 1e-7);
  }
  EXPECT_GT(t.ring.size(), t.size());
}

TEST(Standing, DeadBranchesFallToTheGround) {
  const GrownTree& t = film_tree();
  bool found = false;
  for (std::size_t i = 1; i < t.size() && !found; ++i) {
    if (t.fell[i] > kYears || t.fell[t.parent[i]] == t.fell[i] || t.tip[i].y < 1.5f) continue;
    if (t.fell[t.parent[i]] < t.fell[i] + 4) continue;
    found = true;
    float last = t.tip[i].y;
    bool gone = false;
    for (double year = t.fell[i]; year < t.fell[i] + 8; year += 0.1) {
      Standing now = at(year);
      auto it = std::find(now.source.begin(), now.source.end(), static_cast<std::uint32_t>(i));
      gone = it == now.source.end();
      if (gone) break;
      float y = now.tip[static_cast<std::size_t>(it - now.source.begin())].y;
      EXPECT_LE(y, last + 0.02f);
      last = y;
    }
    EXPECT_TRUE(gone);
    EXPECT_LT(last, 0.6f);
  }
  EXPECT_TRUE(found);
}

/// When the years stand still, what is in the air still comes down, and nothing else moves.
TEST(Standing, FallsEndAfterTheYears) {
  const GrownTree& t = film_tree();
  // The years stand still while something is on its way down.
  float fell = 0;
  for (std::size_t i = 1; i < t.size(); ++i)
    if (t.fell[i] < kYears + 1 && t.tip[i].y > 1) fell = std::max(fell, t.fell[i]);
  double still = fell + 0.05;
  auto later = [&](double overtime) { return standing(t, Species{}, still, {0.5, 1.2, overtime}); };
  Standing first = later(0), last = later(30);
  std::size_t falling = 0;
  for (std::size_t i = 0; i < first.size(); ++i) falling += t.fell[first.source[i]] < GrownTree::kNever;
  EXPECT_GT(falling, 0u);
  for (std::uint32_t source : last.source) EXPECT_GT(t.fell[source], still + 50);
  std::size_t k = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (t.fell[first.source[i]] < GrownTree::kNever) continue;
    ASSERT_EQ(first.source[i], last.source[k]);
    EXPECT_EQ(first.tip[i], last.tip[k]);
    EXPECT_EQ(first.leaves[i], last.leaves[k++]);
  }
}

TEST(Standing, LeavesComeAndGo) {
  Standing now = at(10.5);
  std::size_t leafy = 0, bare = 0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    std::uint32_t i = now.source[k];
    bool dead = film_tree().died[i] < 9.5f;
    if (dead) {
      EXPECT_EQ(now.leaves[k], 0);
    }
    ++(now.leaves[k] > 0.9f ? leafy : bare);
    if (10.5f - film_tree().born[i] > 0.5f && 10.5f - film_tree().born[i] < 1 && film_tree().died[i] > 11) {
      EXPECT_GT(now.leaves[k], 0.9f);
    }
  }
  EXPECT_GT(leafy, 100u);
  EXPECT_GT(bare, 100u);
}

}  // namespace
}  // namespace frond
