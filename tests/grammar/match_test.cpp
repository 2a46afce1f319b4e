#include "grammar/fast.h"

#include <gtest/gtest.h>

#include "grammar/turtle.h"

namespace frond {
namespace {

struct Case {
  std::string axiom;
  std::vector<GrammarText::Rule> rules;
  int steps;
  std::string want;
  std::string ignore = {};
  bool ring = false;
  std::string consider = {};
};

TEST(Match, Table) {
  const Case cases[] = {
      // ABOP 1.8: the right context enters the branches it names and passes over the others.
      {"ABC[DE][SG[HI[JK]L]MNO]", {{"BC < S > G[H]M -> Z"}}, 1, "ABC[DE][ZG[HI[JK]L]MNO]"},
      {"SG[X][HI]M", {{"S > G[H]M -> Z"}}, 1, "ZG[X][HI]M"},
      {"SG[X][Y]M", {{"S > G[H]M -> Z"}}, 1, "SG[X][Y]M"},
      {"SG[H[K]I]M", {{"S > G[H[K]]M -> Z"}}, 1, "ZG[H[K]I]M"},
      {"S[A][B]C", {{"S > [A][B]C -> Z"}}, 1, "Z[A][B]C"},
      {"S[A][B]C", {{"S > [B][A]C -> Z"}}, 1, "S[A][B]C"},
      {"S[+A]C", {{"S > [A]C -> Z"}}, 1, "Z[+A]C", "+"},
      // ABOP figure 1.30b: a signal from the tip down.
      {"a[+a]a[-a]a[+a]b", {{"a > b -> b"}}, 3, "b[+a]b[-a]b[+a]b", "+-"},
      // The right context stays in its own branch.
      {"A[B]C", {{"B > C -> Z"}}, 1, "A[B]C"},
      {"A[B]C", {{"A > C -> Z"}}, 1, "Z[B]C"},
      {"A[B]C", {{"A < C -> Z"}}, 1, "A[B]Z"},
      {"A[B]C", {{"B < C -> Z"}}, 1, "A[B]C"},
      {"[A]B", {{"A < B -> Z"}}, 1, "[A]B"},
      // A circle; a word of one letter is its own neighbour.
      {"AB", {{"B < A -> C"}}, 1, "CB", "", true},
      {"A", {{"A < A > A -> B"}}, 1, "B", "", true},
      {"ABC", {{"AABC < A -> Z"}}, 1, "ABC", "", true},
      {"ABC", {{"BCABC < A -> Z"}}, 1, "ZBC", "", true},
      {"+A+B+", {{"B < A > B -> Z"}}, 1, "+Z+B+", "+", true},
      // Lists of what contexts see.
      {"AxyB", {{"A < B -> Z"}}, 1, "AxyZ", "", false, "AB"},
      // Parameters of both sides.
      {"A(1)B(2)C(4)", {{"A(x) < B(y) > C(z) : x < y -> B(x+10*y+100*z)"}}, 1, "A(1)B(421)C(4)"},
      {"A(1)A(2)[X(9)]B(3)C(4)D(5,6)",
       {{"A(a)A(b) < B(c) > C(d)D(e,f) -> B(a,b,c,d,e,f)"}},
       1,
       "A(1)A(2)[X(9)]B(1,2,3,4,5,6)C(4)D(5,6)"},
      {"B(1)[C(2)D(3)]E(4)", {{"B(a) > [C(c)]E(e) -> Z(a,c,e)"}}, 1, "Z(1,2,4)[C(2)D(3)]E(4)"},
  };
  for (const Case& c : cases) {
    GrammarText text;
    text.axiom = c.axiom;
    text.rules = c.rules;
    text.ignore = c.ignore;
    text.consider = c.consider;
    text.ring = c.ring;
    Result<Grammar> grammar = compile(text);
    ASSERT_TRUE(grammar.ok()) << grammar.errors()[0].text();
    Result<Word> word = derive(*grammar, c.steps, Seed{1});
    ASSERT_TRUE(word.ok()) << word.errors()[0].text();
    EXPECT_EQ(frond::text(*grammar, *word), c.want) << c.axiom << " by " << c.rules[0].text;
  }
}

TEST(Match, TheEnvironmentAnswersQuestions) {
  GrammarText text;
  text.axiom = "A";
  text.rules = {{"A -> F?E(0,0)A"}, {"?E(k,x) : x > 1.5 -> B"}};
  text.symbols = {"?E"};
  Grammar grammar = std::move(*compile(text));
  EXPECT_EQ(frond::text(grammar, *derive(grammar, 2, Seed{1})), "F?E(0,0)F?E(0,0)A");
  grammar.environment = [](const TurtleState& turtle, std::span<double> answer) {
    answer[1] = turtle.position.y;
  };
  EXPECT_EQ(frond::text(grammar, *derive(grammar, 3, Seed{1})), "F?E(0,1)FBF?E(0,3)A");
}

TEST(Match, RulesForWordsInterpretedToADepth) {
  GrammarText text;
  text.axiom = "A";
  text.rules = {{"B -> B"}};
  text.interpretation = {{"A -> FA"}, {"F -> GG"}};
  const char* want[] = {"A", "FA", "GGFA", "GGGGFA"};
  for (int depth = 0; depth < 4; ++depth) {
    text.interpretation_depth = depth;
    Grammar grammar = std::move(*compile(text));
    EXPECT_EQ(frond::text(grammar, interpret(grammar, grammar.axiom, Seed{1})), want[depth]);
  }
}

}  // namespace
}  // namespace frond
