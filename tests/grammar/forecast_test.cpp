#include "grammar/forecast.h"

#include <gtest/gtest.h>

#include "grammar/corpus.h"

namespace frond {
namespace {

TEST(Forecast, IsExactWhereEachSymbolHasOneRule) {
  int tried = 0;
  for (const auto& c : corpus()) {
    if (c["group"] != "D0L" && c["group"] != "parametric") continue;
    Grammar grammar = std::move(*compile(grammar_of(c)));
    if (!has_growth_matrix(grammar)) continue;
    SCOPED_TRACE(c["name"].get<std::string>());
    Forecast predicted = forecast(grammar, c["n"], Seed{1});
    Word word = *derive(grammar, c["n"], Seed{1});
    EXPECT_EQ(predicted.modules, static_cast<double>(word.size()));
    EXPECT_EQ(predicted.bytes, static_cast<double>(word.bytes()));
    EXPECT_EQ(predicted.segments, static_cast<double>(stats_of(grammar, word, Seed{1}).segments));
    ++tried;
  }
  EXPECT_GT(tried, 35);
}

TEST(Forecast, RefusesRunawaysWithFigureAndStep) {
  GrammarText text;
  text.rules = {{"F -> FFFFFFFFFF"}};
  Grammar grammar = std::move(*compile(text));
  Result<Word> word = derive(grammar, 50, Seed{1});
  ASSERT_FALSE(word.ok());
  EXPECT_NE(word.errors()[0].what.find("step 9"), std::string::npos) << word.errors()[0].what;
  EXPECT_NE(word.errors()[0].what.find("1 billion"), std::string::npos);
  EXPECT_TRUE(derive(grammar, 5, Seed{1}).ok());
  text.rules = {{"F(x) : x < 100 -> F(x)F(x)F(x)"}};
  text.axiom = "F(1)";
  grammar = std::move(*compile(text));
  Forecast guess = forecast(grammar, 30, Seed{1});
  EXPECT_EQ(guess.kind, Forecast::Kind::extrapolated);
  EXPECT_EQ(guess.passes_at, 18);
  EXPECT_FALSE(derive(grammar, 30, Seed{1}, {1000, 100000}).ok());
  EXPECT_FALSE(stats_of(grammar, 30, Seed{1}, {1000, 100000}).ok());
  EXPECT_EQ(stats_of(grammar, 4, Seed{1})->segments, 81u);
}

TEST(Forecast, GivesTheMeanWhereLotsAreDrawn) {
  for (const auto& c : corpus()) {
    if (c["name"] != "abop-1.27") continue;
    Grammar grammar = std::move(*compile(grammar_of(c)));
    Forecast predicted = forecast(grammar, 5, Seed{1});
    EXPECT_EQ(predicted.kind, Forecast::Kind::expected);
    EXPECT_NEAR(predicted.segments, 656.7580836576001, 1e-6);
  }
}

Grammar decomposing(std::vector<GrammarText::Rule> decomposition, const std::string& axiom = "AB") {
  GrammarText text;
  text.axiom = axiom;
  text.rules = {{"A -> AA"}};
  text.decomposition = std::move(decomposition);
  return std::move(*compile(text));
}

TEST(Forecast, SeesWhatDecompositionMakes) {
  Grammar grammar = decomposing({{"B -> CCC"}, {"C -> FF[+F]"}});
  EXPECT_TRUE(has_growth_matrix(grammar));
  Forecast predicted = forecast(grammar, 5, Seed{1});
  Word word = *derive(grammar, 5, Seed{1});
  EXPECT_EQ(predicted.kind, Forecast::Kind::exact);
  EXPECT_EQ(predicted.modules, static_cast<double>(word.size()));
  EXPECT_EQ(predicted.segments, 9);
  // Four times as many with each of the rules: refused at once, although the axiom has one module.
  std::vector<GrammarText::Rule> fourfold;
  for (char c = 'a'; c < 'z'; ++c)
    fourfold.push_back({std::string{c} + " -> " + std::string(4, static_cast<char>(c + 1))});
  predicted = forecast(decomposing(fourfold, "a"), 1, Seed{1});
  EXPECT_EQ(predicted.passes_at, 1);
  EXPECT_GT(predicted.modules, 1e9);
}

TEST(Forecast, SaysAtLeastWhereOneStepOfTheDryRunIsTooMuch) {
  Grammar grammar = decomposing({{"B(i) : i > 0 -> B(i-1)B(i-1)"}}, "B(24)");
  Forecast predicted = forecast(grammar, 1, Seed{1});
  EXPECT_EQ(predicted.kind, Forecast::Kind::at_least);
  EXPECT_GE(predicted.modules, 1e6);
  EXPECT_LE(predicted.modules, 16777216);
  EXPECT_FALSE(refuse(forecast(grammar, 1, Seed{1}, {1000, 1 << 20}), {1000, 1 << 20}).empty());
}

TEST(Forecast, DoesNotGoOnAtTheRateOfABurst) {
  // In step 5 the 81 modules become 116,640, and in the next two steps no more.
  GrammarText text;
  text.axiom = "A(4)";
  text.rules = {{"A(n) : n > 0 -> A(n-1)A(n-1)A(n-1)"}, {"A(n) : n <= 0 -> Q(480)"}};
  text.decomposition = {{"Q(n) : n > 0 -> FFFQ(n-1)"}, {"Q(n) : n <= 0 -> "}};
  Grammar grammar = *compile(text);
  Forecast predicted = forecast(grammar, 7, Seed{1});
  EXPECT_EQ(predicted.modules, static_cast<double>(derive(grammar, 7, Seed{1})->size()));
  EXPECT_EQ(predicted.kind, Forecast::Kind::exact);
}

TEST(Forecast, TellsHowManyStepsTakeAMoment) {
  // Each step adds a module, so all words together have a hundred thousand times as many as the last.
  for (const char* rule : {"A -> FA", "A(x) -> FA(x+1)", "A < A -> A"}) {
    GrammarText text;
    text.axiom = rule[1] == '(' ? "A(0)" : "A";
    text.rules = {{rule}};
    Grammar grammar = *compile(text);
    Forecast predicted = forecast(grammar, 100'000, Seed{1});
    int small = predicted.small_steps;
    EXPECT_GT(small, 1000) << rule;
    EXPECT_LE(forecast(grammar, small, Seed{1}).work, 3e6) << rule;
    EXPECT_GE(predicted.work, 1e5) << rule;
  }
  // Few steps of a small word are counted as they are.
  GrammarText text;
  text.rules = {{"F -> FF"}};
  EXPECT_EQ(forecast(*compile(text), 5, Seed{1}).small_steps, 5);
  EXPECT_LT(forecast(*compile(text), 25, Seed{1}).small_steps, 20);
}

TEST(Forecast, StaysFinite) {
  GrammarText text;
  text.rules = {{"F -> FFFFFFFFFF"}};
  Forecast predicted = forecast(*compile(text), 100'000, Seed{1});
  EXPECT_TRUE(std::isfinite(predicted.modules) && std::isfinite(predicted.segments) &&
              std::isfinite(predicted.bytes) && std::isfinite(predicted.passes_with));
}

}  // namespace
}  // namespace frond
