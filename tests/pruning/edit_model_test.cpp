#include <gtest/gtest.h>

#include "pruning/edits.h"
#include "pruning/tiny_tree.h"

namespace frond {
namespace {

Edit cut_at(const char* at) { return {.at = *parse_address(at), .cut = 0}; }
Edit bend_at(const char* at, Vec3 by) { return {.at = *parse_address(at), .bend = by}; }
Edit strengthen_at(const char* at, double by) { return {.at = *parse_address(at), .strength = by}; }

Model edited(const std::vector<Edit>& edits) {
  Model m = tiny_model();
  edit_model(m, edits);
  EXPECT_EQ(m.find_fault(), "");
  return m;
}

Vec3 place_of(const Model& m, const char* at) {
  std::vector<AxisNode> axes = axis_nodes(m);
  Branching plant{m.skeleton.parent, axes};
  BranchPlace p = *find_place(plant, axis_starts(plant), *parse_address(at));
  const Skeleton& s = m.skeleton;
  return glm::mix(s.position[s.parent[p.node]], s.position[p.node], p.within);
}

bool equal(const Model& a, const Model& b) {
  return a.skeleton.position == b.skeleton.position && a.skeleton.radius == b.skeleton.radius &&
         a.skeleton.parent == b.skeleton.parent && a.skeleton.distance == b.skeleton.distance &&
         a.organs.position == b.organs.position && a.organs.turn == b.organs.turn &&
         a.blades.surface.position == b.blades.surface.position && a.axes == b.axes;
}

TEST(Edits, WithoutAnyNothingChanges) {
  EXPECT_TRUE(equal(edited({}), tiny_model()));
  EXPECT_TRUE(equal(edited({bend_at("1:0.5", Vec3(0)), strengthen_at("1", 1)}), tiny_model()));
}

TEST(Edits, ACutLeavesNothingBeyond) {
  Model m = edited({cut_at("1:0.5")});
  const Model before = tiny_model();
  EXPECT_EQ(m.skeleton.size(), before.skeleton.size() - 4);  // the twig hangs beyond, too
  EXPECT_EQ(m.blades.size(), 0u);
  EXPECT_TRUE(m.blades.surface.position.empty());
  // The round end of the branch reaches to where it was cut, and the face of the cut lies there.
  const Vec3 at = place_of(before, "1:0.5");
  const std::size_t end = kLowBranch + 1;
  EXPECT_NEAR(glm::distance(m.skeleton.position[end], at), m.skeleton.radius[end], 1e-5f);
  ASSERT_EQ(m.organs.size(), 9u);
  const Vec3 up = m.organs.turn.back() * Vec3(0, m.organs.scale.back().y, 0);
  EXPECT_LT(glm::distance(m.organs.position.back() + up, at), 1e-5f);
  EXPECT_EQ(m.prototypes.back().name, "sawn");
  for (std::size_t i = 0; i + 1 < m.organs.size(); ++i) EXPECT_LT(m.organs.position[i].x, at.x);
}

TEST(Edits, ACutAtTheFootLeavesTheCollar) {
  Model m = edited({cut_at("2")});
  EXPECT_EQ(m.skeleton.size(), tiny_tree().size() - 2);
  // To the face of the cut.
  float stub =
      glm::distance(m.skeleton.position[3], m.skeleton.position[kHighBranch]) + m.organs.scale.back().y;
  EXPECT_GT(stub, m.skeleton.radius[3]);
  EXPECT_LT(stub, 3 * m.skeleton.radius[3]);
}

TEST(Edits, ACutStemLeavesAStump) {
  Model m = edited({cut_at("")});
  EXPECT_EQ(m.skeleton.size(), 2u);
  EXPECT_NEAR(m.skeleton.position[1].y, 0.1f, 0.05f);
}

TEST(Edits, CutsOnOneAnotherAreTheDeeperOne) {
  EXPECT_TRUE(equal(edited({cut_at("1/1:0.5"), cut_at("1:0.5")}), edited({cut_at("1:0.5")})));
  EXPECT_TRUE(equal(edited({cut_at("1:0.52"), cut_at("1:0.5")}), edited({cut_at("1:0.5")})));
}

TEST(Edits, ABendKeepsLengthsAndReachesItsTarget) {
  const Model before = tiny_model();
  for (Vec3 by : {Vec3(0.1f, -0.3f, 0), Vec3(-0.2f, 0.5f, 0.4f), Vec3(-1.2f, -1, 0), Vec3(0, 0.02f, 0)}) {
    Model m = edited({bend_at("1:0.8", by)});
    const Skeleton &a = before.skeleton, &b = m.skeleton;
    for (std::size_t i = 1; i < a.size(); ++i)
      EXPECT_NEAR(glm::distance(b.position[i], b.position[b.parent[i]]),
                  glm::distance(a.position[i], a.position[a.parent[i]]), 1e-4f);
    for (std::int32_t i = 0; i < kLowBranch; ++i) EXPECT_EQ(a.position[i], b.position[i]);
    for (std::size_t i = kHighBranch; i < a.size(); ++i) EXPECT_EQ(a.position[i], b.position[i]);
    Vec3 clamp = a.position[1], from = place_of(before, "1:0.8"), wanted = from + by;
    const float reach = glm::distance(clamp, from);
    if (glm::distance(clamp, wanted) < 0.95f * reach) {
      EXPECT_LT(glm::distance(place_of(m, "1:0.8"), wanted), 0.01f * reach) << by.x << " " << by.y;
    }
  }
}

TEST(Edits, ABendBeyondReachGoesAsFarAsItCan) {
  Model m = edited({bend_at("1:1", Vec3(0, 50, 0))});
  Vec3 way = place_of(m, "1:1") - m.skeleton.position[1];
  EXPECT_GT(way.y / glm::length(way), 0.9f);
}

TEST(Edits, WhatHangsOnALimbRidesAlong) {
  const Model before = tiny_model();
  Model m = edited({bend_at("1:0.5", Vec3(0, -0.4f, 0))});
  for (std::size_t i = 0; i < m.organs.size(); ++i)
    EXPECT_NEAR(glm::distance(m.organs.position[i], m.skeleton.position[m.organs.node[i]]), 0.01f, 1e-5f);
  EXPECT_NE(m.organs.turn[kTwig], before.organs.turn[kTwig]);
  EXPECT_LT(glm::distance(m.blades.foot[0], m.skeleton.position[kTwig + 1]), 1e-5f);
}

TEST(Edits, ThickWoodBendsLess) {
  Model m = tiny_model();
  for (std::int32_t i = kLowBranch; i < kTwig; ++i)
    m.skeleton.radius[i] = 0.06f - 0.01f * static_cast<float>(i - kLowBranch);
  edit_model(m, std::vector{bend_at("1:1", Vec3(-0.016f, 0.099f, 0))});
  const Skeleton &a = tiny_tree(), &b = m.skeleton;
  auto turned = [&](std::int32_t i) {
    Vec3 was = glm::normalize(a.position[i] - a.position[a.parent[i]]);
    Vec3 is = glm::normalize(b.position[i] - b.position[b.parent[i]]);
    return std::acos(std::min(1.0f, glm::dot(was, is)));
  };
  // Of a beam of even thickness the first of three joints turns 1.5 times as much as the second. The second
  // segment has turned by both.
  EXPECT_GT(turned(kLowBranch), 0);
  EXPECT_LT(turned(kLowBranch), turned(kLowBranch + 1) - turned(kLowBranch));
}

TEST(Edits, StrengthIsAFactorOfLengthAndThickness) {
  const Model before = tiny_model();
  Model m = edited({strengthen_at("1", 1.5)});
  const Skeleton &a = before.skeleton, &b = m.skeleton;
  for (std::size_t i = 1; i < a.size(); ++i) {
    const float by = i >= kLowBranch && i < kHighBranch ? 1.5f : 1;
    EXPECT_NEAR(b.radius[i], by * a.radius[i], 1e-6f);
    EXPECT_NEAR(glm::distance(b.position[i], b.position[b.parent[i]]),
                by * glm::distance(a.position[i], a.position[a.parent[i]]), 1e-5f);
  }
}

TEST(Edits, ABareBranchKeepsItsWoodAndNothingElse) {
  const Model before = tiny_model();
  Model m = edited({{.at = *parse_address("1:0.5"), .bare = true}});
  EXPECT_EQ(m.skeleton.position, before.skeleton.position);
  const Vec3 at = place_of(before, "1:0.5");
  EXPECT_EQ(m.blades.size(), 0u);
  EXPECT_TRUE(m.blades.surface.position.empty());
  EXPECT_LT(m.organs.size(), before.organs.size());
  std::size_t left = 0;
  for (Vec3 leaf : before.organs.position) left += !(leaf.x >= at.x);
  EXPECT_EQ(m.organs.size(), left);
  for (Vec3 leaf : m.organs.position) EXPECT_LT(leaf.x, at.x);
  // The face of a cut on it stays, and so do other edits.
  Edit bare{.at = *parse_address("1"), .bare = true};
  for (const std::vector<Edit>& edits :
       {std::vector{cut_at("1:0.5"), bare}, std::vector{bare, cut_at("1:0.5")}}) {
    m = edited(edits);
    EXPECT_EQ(m.skeleton.size(), edited({cut_at("1:0.5")}).skeleton.size());
    ASSERT_GT(m.organs.size(), 0u);
    EXPECT_EQ(m.prototypes[m.organs.prototype.back()].name, "sawn");
  }
  // An edit of what a stripped model has no more is passed over.
  strip_model(m, std::vector<Edit>{{.at = *parse_address("7"), .bare = true}});
  EXPECT_EQ(m.find_fault(), "");
}

TEST(Edits, AnotherBarkIsAColourOfItsOwnBeyondThePlace) {
  const Edit low{.at = *parse_address("1"), .bark = BarkChange{}},
      twig{.at = *parse_address("1/1"), .bark = BarkChange{}};
  Model m = tiny_model();
  color_barks(m, std::vector<Edit>{cut_at("2")}, 3);
  EXPECT_TRUE(m.color.empty()) << "without such an edit nothing changes";
  // The plant has three colours, which go round and round.
  m.color.assign(m.skeleton.size(), 4);
  color_barks(m, std::vector<Edit>{low, cut_at("2"), twig, {.at = *parse_address("7"), .bark = BarkChange{}}},
              3);
  for (std::size_t i = 0; i < m.color.size(); ++i) {
    const auto node = static_cast<std::int32_t>(i);
    const bool on_low = node >= kLowBranch && node < kTwig, on_twig = node >= kTwig && node < kHighBranch;
    EXPECT_EQ(m.color[i], on_twig ? 4 : on_low ? 3 : 1) << i;
  }
  // From the middle of a branch on, by whole segments; what is cut off takes its colours along.
  m = tiny_model();
  color_barks(m, std::vector<Edit>{{.at = *parse_address("1:0.4"), .bark = BarkChange{}}}, 1);
  EXPECT_EQ(m.color[kLowBranch], 0);
  EXPECT_EQ(m.color[kLowBranch + 1], 1);
  const std::size_t before = m.color.size();
  edit_model(m, std::vector<Edit>{cut_at("1/1")});
  EXPECT_LT(m.color.size(), before);
  EXPECT_EQ(m.color.size(), m.skeleton.size());
  EXPECT_EQ(m.find_fault(), "");
}

TEST(Edits, LeaveTheAddressesOfOthers) {
  const Model before = tiny_model();
  std::vector<AxisNode> axes = axis_nodes(before);
  for (const Edit& edit :
       {cut_at("1:0.5"), cut_at("1"), bend_at("1:0.7", Vec3(0, 0.3f, 0)), strengthen_at("1", 2)}) {
    Model m = edited({edit});
    Vec3 branch = place_of(m, "2:0.6"), stem = place_of(m, ":0.9");
    EXPECT_LT(glm::distance(branch, place_of(before, "2:0.6")), 1e-5f);
    EXPECT_LT(glm::distance(stem, place_of(before, ":0.9")), 1e-5f);
  }
}

TEST(Edits, TellWhatTheyDoNotFind) {
  Model m = tiny_model();
  std::vector<Edit> edits = edits_of(std::vector{cut_at("1"), cut_at("7")}, 0);
  edit_model(m, edits);
  ASSERT_EQ(m.notes.size(), 1u);
  EXPECT_EQ(m.notes[0], "/edits/1/at: finds no branch: the stem has 2 branches");
}

TEST(Edits, AreOfThePlantThatIsMeant) {
  std::vector<Edit> edits{cut_at("1"), cut_at("2")};
  edits[1].plant = 3;
  EXPECT_EQ(edits_of(edits, 0).size(), 1u);
  EXPECT_EQ(edits_of(edits, 3).size(), 2u);
  EXPECT_EQ(edits_of(edits, std::nullopt).size(), 1u);
}

TEST(Edits, BendAPartThatHasGrownInProportion) {
  Model whole = tiny_model(), part = tiny_model();
  std::vector<Edit> edits{bend_at("1:1", Vec3(0, -0.6f, 0))};
  std::vector<float> levers = edit_model(whole, edits);
  for (Vec3& p : part.skeleton.position) p *= 0.5f;
  edit_model(part, edits, levers);
  for (std::size_t i = 0; i < whole.skeleton.size(); ++i)
    EXPECT_LT(glm::distance(part.skeleton.position[i], 0.5f * whole.skeleton.position[i]), 2e-3f);
}

}  // namespace
}  // namespace frond
