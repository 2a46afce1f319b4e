#include "grammar/review.h"

#include <gtest/gtest.h>

#include <set>

#include "grammar/corpus.h"

namespace frond {
namespace {

using Rules = std::vector<GrammarText::Rule>;

std::string refused(const Rules& decomposition) {
  GrammarText text;
  text.decomposition = decomposition;
  Result<Grammar> grammar = compile(text);
  return grammar ? "" : grammar.errors()[0].text();
}

TEST(Review, EndlessDecompositionsNameTheirRule) {
  EXPECT_NE(refused({{"F -> FF"}}).find("decomposition rule 1: column 1: `F -> FF` never ends"),
            std::string::npos);
  EXPECT_NE(refused({{"F -> FX"}}).find("taken apart into `F` again"), std::string::npos);
  EXPECT_NE(refused({{"A -> B"}, {"B -> XC"}, {"C -> B"}}).find("rule 3: column 1: `C -> B` never ends"),
            std::string::npos);
  EXPECT_NE(refused({{"F ->(1) FX"}, {"F ->(2) XF"}}).find("never ends"), std::string::npos);
  EXPECT_NE(refused({{"F(x) : x > 1 -> X"}, {"F(x) -> F(x/2)F(x/2)"}}).find("`F(x)"), 0u);
}

TEST(Review, DecompositionsThatMayEndAreNotRefused) {
  EXPECT_EQ(refused({{"F ->(1) FF"}, {"F ->(9) X"}}), "");
  EXPECT_EQ(refused({{"F(x) : x > 1 -> F(x/2)F(x/2)"}}), "");
  EXPECT_EQ(refused({{"F(x) : x > 1 -> F(x/2)F(x/2)"}, {"F(x) -> X"}}), "");
  EXPECT_EQ(refused({{"F ->(0) FF"}}), "");
  EXPECT_EQ(refused({{"A -> BB"}, {"B -> CC"}}), "");
}

TEST(Review, LimitsThatWouldNotBeHeededAreRefused) {
  EXPECT_NE(refused({{"F -> XX", 3}}).find("has no limit of its own"), std::string::npos);
}

Errors warnings_of(const std::string& axiom, const Rules& rules,
                   const std::vector<std::string>& organs = {}) {
  GrammarText text;
  text.axiom = axiom;
  text.rules = rules;
  text.organs = organs;
  Result<Grammar> grammar = compile(text);
  return grammar ? grammar->warnings : grammar.errors();
}

TEST(Review, SymbolsThatNothingKnowsAreToldWithRuleAndColumn) {
  Errors warnings = warnings_of("A", {{"A -> F[+X]A"}});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].text().find("rule 1: column 9: `X` does nothing"), 0u) << warnings[0].text();
}

TEST(Review, SymbolsThatSomebodyLooksForAreNoSlip) {
  EXPECT_TRUE(warnings_of("FX", {{"X < F -> FF"}}).empty());  // only a context
  EXPECT_TRUE(warnings_of("A", {{"A -> F~K"}}).empty());
  EXPECT_TRUE(warnings_of("A", {{"A -> F[K]"}}, {"K"}).empty());
  EXPECT_TRUE(warnings_of("FX", {{"F -> FF"}}).empty());  // the axiom marks a place
  EXPECT_TRUE(warnings_of("AX", {{"A -> AB"}}).empty());  // nothing is drawn: a word alone
}

TEST(Review, KnownGrammarsRaiseNoFalseAlarm) {
  std::set<std::string> told;
  for (const auto& c : corpus()) {
    if (!c.contains("rules")) continue;
    Result<Grammar> grammar = compile(grammar_of(c));
    ASSERT_TRUE(grammar.ok()) << grammar.errors()[0].text();
    for (const Error& warning : grammar->warnings)
      told.insert(c["name"].get<std::string>() + warning.text().substr(0, warning.text().find('`')));
  }
  // These end in letters that truly do nothing.
  std::set<std::string> silent{"cpfg-basipetal-Drule 4: column 20: ", "cpfg-basipetal-Drule 6: column 16: ",
                               "seed-bushrule 7: column 9: "};
  EXPECT_EQ(told, silent);
}

}  // namespace
}  // namespace frond
