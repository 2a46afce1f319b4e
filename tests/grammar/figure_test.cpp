#include "grammar/figure.h"

#include <gtest/gtest.h>

#include "grammar/picture.h"
#include "grammar/square.h"

namespace frond {
namespace {

TEST(Figure, BranchesBecomeChains) {
  Grammar grammar = grammar_for("FF[+FF]F[-F]F");
  Skeleton s = *skeleton_of(grammar, grammar.axiom, Seed{1});
  EXPECT_EQ(s.find_fault(), "");
  EXPECT_EQ(s.parent, (std::vector<std::int32_t>{-1, 0, 1, 2, 3, 2, 5, 5}));
  EXPECT_EQ(s.order, (std::vector<std::uint16_t>{0, 0, 0, 1, 1, 0, 1, 0}));
  EXPECT_FLOAT_EQ(s.radius[3], 0.05f);
  EXPECT_FLOAT_EQ(s.distance.back(), 4.0f);
}

TEST(Figure, MovesStartNewRootsAndEmptySegmentsAreLeftOut) {
  Grammar grammar = grammar_for("F(0)FfF(1,0)[F(0)]");
  Skeleton s = *skeleton_of(grammar, grammar.axiom, Seed{1});
  EXPECT_EQ(s.find_fault(), "");
  EXPECT_EQ(s.parent, (std::vector<std::int32_t>{-1, 0, -1, 2}));
}

TEST(Figure, OrgansStandOnTheirNode) {
  Grammar grammar = grammar_for("F[+F~K(2)]{.F.+F.}@O(0.5)");
  Figure figure = figure_of(grammar, grammar.axiom, Seed{1});
  ASSERT_EQ(figure.sites.size(), 2u);
  EXPECT_EQ(figure.sites[0].name, "K");
  EXPECT_EQ(figure.sites[0].node, 2);
  EXPECT_FLOAT_EQ(figure.sites[0].scale.x, 2);
  EXPECT_EQ(figure.sites[1].name, "@O");
  ASSERT_EQ(figure.outlines.size(), 1u);
  EXPECT_EQ(figure.outlines[0].points.size(), 3u);
  EXPECT_EQ(figure.color.size(), figure.skeleton.size());
}

TEST(Figure, WhatIsNotFiniteIsRefused) {
  for (const char* axiom : {"F(1e308)F(1e308)", "[F(1e200)]", "f(1e308)f(1e308)", "\"(1e300)\"(1e300)F"}) {
    GrammarText text;
    text.axiom = axiom;
    Grammar grammar = std::move(*compile(text));
    EXPECT_FALSE(stats_of(grammar, 0, Seed{1}).ok()) << axiom;
    if (std::string(axiom).find('F') == std::string::npos) continue;
    EXPECT_FALSE(figure_of(grammar, 0, Seed{1}).ok()) << axiom;
    EXPECT_FALSE(skeleton_of(grammar, grammar.axiom, Seed{1}).ok()) << axiom;
    EXPECT_EQ(turtle_svg(grammar, 0, Seed{1}).ok(), axiom[0] == '[') << axiom;  // doubles reach so far
  }
}

TEST(Figure, ColoursBeyondAllIntsAreStillColours) {
  GrammarText text;
  text.axiom = ";(1e300)F,(-1e300)F;(1e18);F";
  EXPECT_TRUE(figure_of(*compile(text), 0, Seed{1}).ok());
}

}  // namespace
}  // namespace frond
