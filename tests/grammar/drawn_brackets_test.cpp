#include <gtest/gtest.h>

#include <cmath>

#include "grammar/figure.h"
#include "grammar/forecast.h"
#include "grammar/stream.h"

namespace frond {
namespace {

/// The binary tree whose brackets turn: 0 draws a line that ends in a leaf, 1 a line.
GrammarText binary_tree() {
  GrammarText text;
  text.axiom = "0";
  text.angle = 45;
  text.rules = {{"1 -> 11"}, {"0 -> 1[0]0"}};
  text.interpretation = {{"0 -> F~L"}, {"1 -> F"}, {"[ -> [+"}, {"] -> ]-"}};
  return text;
}

Grammar compiled(const GrammarText& text) {
  Result<Grammar> grammar = compile(text);
  EXPECT_TRUE(grammar.ok()) << (grammar.ok() ? "" : grammar.errors()[0].text());
  return grammar.ok() ? std::move(*grammar) : Grammar{};
}

std::string word_after(const GrammarText& text, int steps) {
  Grammar grammar = compiled(text);
  return frond::text(grammar, *derive(grammar, steps, Seed{1}));
}

TEST(DrawnBrackets, LeaveTheWordsAsTheyAre) {
  EXPECT_EQ(word_after(binary_tree(), 0), "0");
  EXPECT_EQ(word_after(binary_tree(), 1), "1[0]0");
  EXPECT_EQ(word_after(binary_tree(), 2), "11[1[0]0]1[0]0");
  EXPECT_EQ(word_after(binary_tree(), 3), "1111[11[1[0]0]1[0]0]11[1[0]0]1[0]0");
  // They still part branches: for contexts, for `%` and for the rules of a side branch in brackets.
  for (const char* rule : {"1 < 0 > 0 -> 1[%0]0", "1 < 1 -> 0[1]", "1 > [0]0 -> 1%1", "0 < 0 -> [0][1]"}) {
    GrammarText plain = binary_tree(), drawn = binary_tree();
    drawn.rules.insert(drawn.rules.begin(), {rule});
    plain.rules = drawn.rules, plain.interpretation.resize(2);
    drawn.axiom = plain.axiom = "11[10[1]0]1[00]0";
    for (int steps = 0; steps < 5; ++steps) EXPECT_EQ(word_after(drawn, steps), word_after(plain, steps));
  }
}

TEST(DrawnBrackets, TurnAsTurnsBesideThemDo) {
  GrammarText written = binary_tree();
  written.rules = {{"1 -> 11"}, {"0 -> 1[+0]-0"}};
  written.interpretation.resize(2);
  for (Dialect dialect : {Dialect::abop, Dialect::houdini}) {
    GrammarText text = binary_tree();
    text.dialect = written.dialect = dialect;
    text.interpretation_depth = dialect == Dialect::abop ? 1 : 3;  // a drawing's own brackets turn no more
    if (dialect == Dialect::houdini) text.interpretation[0] = written.interpretation[0] = {"0 -> FL"};
    Grammar drawn = compiled(text), plain = compiled(written);
    const std::vector<std::string> leaf{"L"};
    for (int steps = 0; steps < 7; ++steps) {
      Figure figure = *figure_of(drawn, steps, Seed{1}, {}, leaf),
             other = *figure_of(plain, steps, Seed{1}, {}, leaf);
      EXPECT_EQ(figure.sites.size(), std::size_t{1} << steps);
      EXPECT_EQ(figure.skeleton.parent, other.skeleton.parent);
      EXPECT_EQ(figure.skeleton.position, other.skeleton.position);
      EXPECT_EQ(figure_of(drawn, *derive(drawn, steps, Seed{1}), Seed{1}).skeleton.position,
                figure.skeleton.position);
      Forecast size = forecast(drawn, steps, Seed{1}, {});
      EXPECT_EQ(size.segments, static_cast<double>(figure.skeleton.size() - 1)) << steps;
    }
  }
}

TEST(DrawnBrackets, GiveTheKnownTree) {
  Grammar grammar = compiled(binary_tree());
  struct Lines {
    std::vector<Segment> lines;
    void segment(const Segment& line, TurtleState&) { lines.push_back(line); }
  } one, many;
  ASSERT_TRUE(draw(grammar, 1, Seed{1}, one).ok());
  ASSERT_EQ(one.lines.size(), 3u);
  double slant = std::sqrt(0.5);
  EXPECT_NEAR(glm::distance(one.lines[0].to, DVec3(0, 1, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(one.lines[1].to, DVec3(-slant, 1 + slant, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(one.lines[2].to, DVec3(slant, 1 + slant, 0)), 0, 1e-12);
  ASSERT_TRUE(draw(grammar, 6, Seed{1}, many).ok());
  for (const Segment& line : many.lines) {
    DVec3 way = line.to - line.from;
    double eighths = std::atan2(way.x, way.y) / radians(45.0);
    EXPECT_NEAR(eighths, std::round(eighths), 1e-9);
    EXPECT_NEAR(glm::length(way), 1, 1e-9);
  }
}

TEST(DrawnBrackets, TurnGraduallyBetweenSteps) {
  GrammarText text = binary_tree();
  text.interpretation.back() = {"] -> ~K]-F"};  // a line outside of the branch belongs to its axis
  for (const GrammarText& tree : {binary_tree(), text}) {
    Grammar grammar = compiled(tree);
    auto box = [&](double steps) {
      TurtleStats stats = *stats_of(grammar, steps, Seed{1});
      return stats.high - stats.low + DVec3(0, 0, stats.total_length);
    };
    for (int step = 1; step < 5; ++step) {
      EXPECT_NEAR(glm::distance(box(step), box(step - 1e-4)), 0, 1e-3);
      EXPECT_NEAR(glm::distance(box(step), box(step + 1e-4)), 0, 1e-3);
      EXPECT_LT(glm::distance(box(step + 0.5), box(step + 0.501)), 0.01 * box(step).z);
    }
  }
}

TEST(DrawnBrackets, MustStayBrackets) {
  struct WrongDrawing {
    const char* rule;
    const char* says;
  } mistakes[] = {
      {"[ -> +", "what is drawn for `[` holds a `[` of its own; add it"},
      {"] -> -", "what is drawn for `]` holds a `]` of its own; add it"},
      {"[ ->", "what is drawn for `[` holds a `[` of its own; add it"},
      {"[ -> [[+", "this `[` is not closed"},
      {"[ -> [+]", "what is drawn for `[` holds a `[` of its own; add it"},
      {"[ -> ][", "this `]` closes no `[`"},
      {"] -> ]]", "this `]` closes no `[`"},
      {"] -> ]-[F", "this `[` is not closed"},
      {"[ ->(0.5) [+", "a bracket is always drawn alike"},
      {"[ : rand(0,1) > 0.5 -> [+", "a bracket is always drawn alike"},
      {"F < [ -> [+", "has no context"},
  };
  for (const WrongDrawing& mistake : mistakes) {
    GrammarText text = binary_tree();
    text.interpretation = {{"0 -> F"}, {mistake.rule}};
    Result<Grammar> grammar = compile(text);
    ASSERT_FALSE(grammar.ok()) << mistake.rule;
    EXPECT_NE(grammar.errors()[0].what.find(mistake.says), std::string::npos) << grammar.errors()[0].text();
    EXPECT_EQ(grammar.errors()[0].where, "interpretation rule 2");
  }
  GrammarText text = binary_tree();
  text.interpretation[2] = {"[ -> [F][+"}, text.interpretation[3] = {"] -> [F]]-"};
  EXPECT_TRUE(compile(text).ok());
  text.interpretation.push_back({"[ -> [-"});
  EXPECT_FALSE(compile(text).ok());  // which of them?
  text = binary_tree();
  text.rules.push_back({"[ -> [+"});
  EXPECT_NE(compile(text).errors()[0].what.find("brackets cannot be rewritten; an `interpretation` rule"),
            std::string::npos);
  text = binary_tree();
  text.rules[1] = {"0 -> 1[Q]0"};
  EXPECT_EQ(compile(text)->warnings.size(), 1u);
}

}  // namespace
}  // namespace frond
