#include "grammar/lparser_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace frond {
namespace {

GrammarText text_of(std::vector<std::string> rules, int mutations, std::uint64_t seed) {
  GrammarText text;
  text.dialect = Dialect::lparser;
  text.axiom = "A";
  text.mutations = mutations;
  text.seed = seed;
  for (std::string& rule : rules) text.rules.push_back({std::move(rule)});
  return text;
}

std::string rules_of(const GrammarText& text) {
  std::string all;
  for (const GrammarText::Rule& rule : text.rules) all += rule.text + ";";
  return all;
}

TEST(Mutation, TheSeedDecides) {
  const std::vector<std::string> rules{"A -> F[+B]A", "B -> Z[-A]'!B"};
  std::set<std::string> found;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::string once = rules_of(mutated(text_of(rules, 3, seed)));
    EXPECT_EQ(once, rules_of(mutated(text_of(rules, 3, seed))));
    found.insert(once);
  }
  EXPECT_GT(found.size(), 15u);
  EXPECT_EQ(rules_of(mutated(text_of(rules, 0, 5))), "A -> F[+B]A;B -> Z[-A]'!B;");
  EXPECT_EQ(mutated(text_of(rules, 3, 1)).mutations, 0);
}

TEST(Mutation, OneChangesOneThing) {
  // All that one change of these rules can give, by the five kinds of it.
  std::set<std::string> appended, inserted, rest;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    std::string rules = rules_of(mutated(text_of({"A -> +F", "B -> A"}, 1, seed)));
    if (rules.find('[') != std::string::npos)
      inserted.insert(rules);
    else if (rules.size() == std::string("A -> +F;B -> AA;").size())
      appended.insert(rules);
    else
      rest.insert(rules);
  }
  EXPECT_EQ(appended, (std::set<std::string>{"A -> +FA;B -> A;", "A -> +FB;B -> A;", "A -> +F;B -> AA;",
                                             "A -> +F;B -> AB;"}));
  EXPECT_EQ(inserted.size(), 10u);  // A or B at three places of the first rule and two of the second
  EXPECT_TRUE(inserted.contains("A -> +[B]F;B -> A;"));
  EXPECT_EQ(rest, (std::set<std::string>{"A -> +F;B -> A;", "A -> -F;B -> A;", "A -> +Z;B -> A;",
                                         "A -> +F;B -> B;"}));
}

TEST(Mutation, AnyNumberOfThemCompiles) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    GrammarText text = text_of({"A -> F(20)[+(30)B]A", "B -> Z[-A]'!B", "C -> "}, 40, seed);
    Result<Grammar> grammar = compile(text);
    ASSERT_TRUE(grammar.ok()) << grammar.errors()[0].text();
  }
}

TEST(LParserRules, OtherDialectsStayAsTheyAre) {
  GrammarText text = text_of({"A -> F(20)A", "F -> FF"}, 4, 1);
  EXPECT_EQ(lparser_rules(text_of({"A -> F(20)A", "F -> FF"}, 0, 1)).rules.size(), 3u);
  text.dialect = Dialect::abop;
  EXPECT_EQ(rules_of(lparser_rules(text)), "A -> F(20)A;F -> FF;");
}

}  // namespace
}  // namespace frond
