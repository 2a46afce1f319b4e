#include <gtest/gtest.h>

#include "grammar/derive.h"

namespace frond {
namespace {

/// One a line.
std::string all_of(const Errors& errors) {
  std::string all;
  for (const Error& error : errors) all += error.text() + "\n";
  return all;
}

Result<Grammar> compiled(const std::vector<std::string>& rules, const std::string& axiom) {
  GrammarText text;
  text.axiom = axiom;
  text.constants = {{"r", "2"}};
  for (const std::string& rule : rules) text.rules.push_back({rule});
  return compile(text);
}

/// All messages for a grammar with these rules.
std::string messages(const std::vector<std::string>& rules, const std::string& axiom = "A") {
  Result<Grammar> grammar = compiled(rules, axiom);
  return grammar ? "" : all_of(grammar.errors());
}

/// What is noted of a grammar with these rules, which has no mistake.
std::string notes(const std::vector<std::string>& rules) {
  Result<Grammar> grammar = compiled(rules, "A");
  return grammar ? all_of(grammar->warnings) : "refused: " + all_of(grammar.errors());
}

struct Mistake {
  const char* rule;
  const char* says;
};

TEST(Compile, MistakesNameRuleAndPlace) {
  const Mistake mistakes[] = {
      {"A -> F[+F", "column 7: this `[` is not closed"},
      {"A -> F]", "column 7: this `]` closes no `[`"},
      {"A -> F(sine(3))", "column 8: there is no function `sine`; did you mean `sin`?"},
      {"A -> F(sin(3,4))", "`sin` takes 1 parameter, 2 given"},
      {"A -> F(max(3))", "`max` takes 2 parameters, 1 given"},
      {"A ->(-0.5) F", "the weight is -0.5; it must be 0 or more"},
      {"A(x) -> F(y)", "`y` is not a parameter of the rule, nor a constant"},
      {"A(x,x) -> F", "the parameter `x` is named twice"},
      {"A(3) -> F", "a parameter of the left side is a name"},
      {"AB -> F", "the predecessor is one module"},
      {"A F", "no arrow"},
      {"-> F", "there is no predecessor"},
      {"A -> F(1", "the parameters of `F` are not closed"},
      {"A -> F(1+)", "a number, a name or `(` is expected"},
      {"A -> (3", "the weight is not closed"},
      {"A : 0 -> F", "the condition is never true"},
      {"A : r > -> F", "a number, a name or `(` is expected"},
      {"A -> F(1/0)", "division by zero"},
      {"B[C] < A -> F", "the left context is the path to the root"},
      {"A > [B -> F", "the brackets of the right context do not match"},
      {"[ -> F", "brackets cannot be rewritten"},
  };
  for (const Mistake& mistake : mistakes) {
    std::string all = messages({"B -> B", mistake.rule});
    EXPECT_NE(all.find(mistake.says), std::string::npos) << mistake.rule << " gives: " << all;
    EXPECT_NE(all.find("rule 2"), std::string::npos) << all;
  }
}

TEST(Compile, AllMistakesAreReported) {
  std::string all = messages({"A -> F[", "B -> F(q)", "C F"}, "A]");
  for (const char* part : {"rule 1", "rule 2", "rule 3", "axiom"})
    EXPECT_NE(all.find(part), std::string::npos) << all;
}

TEST(Compile, RulesThatCanNeverMatchAreNotedAndStopNothing) {
  EXPECT_NE(notes({"A -> B", "A -> C"}).find("can never be used"), std::string::npos);
  EXPECT_NE(notes({"A -> B", "X < A -> C"})
                .find("rule 2: column 5: `X < A -> C` can never be used: `A -> B` (rule 1)"),
            std::string::npos);
  EXPECT_NE(notes({"X < A -> B", "X < A : r > 1 -> C"}).find("can never be used"), std::string::npos);
  EXPECT_EQ(notes({"A ->(1) B", "A ->(2) C"}).find("can never"), std::string::npos);
  EXPECT_EQ(notes({"X < A -> B", "A -> C"}).find("can never"), std::string::npos);
  EXPECT_EQ(messages({"A -> B", "A -> C"}), "");
  GrammarText past;
  past.rules = {{"+ < A -> B"}};
  past.ignore = "+";
  ASSERT_TRUE(compile(past).ok());
  EXPECT_NE(all_of(compile(past)->warnings).find("contexts look past"), std::string::npos);
}

TEST(Compile, ALimitIsAtLeastOne) {
  GrammarText limited;
  limited.rules = {{"A -> B", 2}, {"A -> C"}};
  EXPECT_TRUE(compile(limited).ok());
  limited.rules = {{"A -> B", -1}};
  ASSERT_FALSE(compile(limited).ok());
  EXPECT_NE(compile(limited).errors()[0].what.find("the limit is -1; it must be 1 or more"),
            std::string::npos);
}

TEST(Compile, InterpretationWithoutEndIsRefused) {
  GrammarText text;
  text.interpretation = {{"F -> FF"}};
  text.interpretation_depth = 3;
  EXPECT_TRUE(compile(text).ok());
  text.interpretation_depth = 60;
  ASSERT_FALSE(compile(text).ok());
  EXPECT_NE(compile(text).errors()[0].what.find("lower `interpretation_depth`"), std::string::npos);
}

TEST(Compile, ConstantsMayUseEachOther) {
  GrammarText text;
  text.axiom = "A(1)";
  text.constants = {{"q", "1-r"}, {"r", "p*2"}, {"p", "0.25"}, {"w", "[1, 2, q*10]"}};
  text.rules = {{"A(i) -> F(q)G(w[i],ramp(w,0.25))"}};
  Result<Grammar> grammar = compile(text);
  ASSERT_TRUE(grammar.ok()) << grammar.errors()[0].text();
  EXPECT_EQ(frond::text(*grammar, *derive(*grammar, 1, Seed{1})), "F(0.5)G(2,1.5)");
  text.constants = {{"a", "b"}, {"b", "a"}};
  EXPECT_EQ(compile(text).errors().size() >= 2, true);
}

TEST(Compile, SymbolsMayBeWordsAndForeignLetters) {
  GrammarText text;
  text.axiom = "Leaf\u00e4L";
  text.symbols = {"Leaf"};
  text.rules = {{"\u00e4 \u2192 Leaf(1)\u00e4"}, {"Leaf -> L"}, {"- -> +"}};
  Grammar grammar = std::move(*compile(text));
  EXPECT_EQ(grammar.axiom.size(), 3u);
  EXPECT_EQ(frond::text(grammar, *derive(grammar, 1, Seed{1})), "LLeaf(1)\u00e4L");
  ASSERT_EQ(grammar.warnings.size(), 1u);
}

}  // namespace
}  // namespace frond
