#include "grammar/rewrite.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include "grammar/figure.h"
#include "grammar/forecast.h"

namespace frond {
namespace {

/// Does the work on a stack of its own, of 256 KB.
template <class Work>
void on_a_small_stack(Work work) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, std::size_t{256} << 10), 0);
  pthread_t thread;
  auto run = [](void* what) -> void* { return (*static_cast<Work*>(what))(), nullptr; };
  ASSERT_EQ(pthread_create(&thread, &attributes, run, &work), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

Grammar grammar_with(const std::string& axiom, std::vector<GrammarText::Rule> decomposition) {
  GrammarText text;
  text.axiom = axiom;
  text.decomposition = std::move(decomposition);
  Result<Grammar> grammar = compile(text);
  if (grammar) return std::move(*grammar);
  ADD_FAILURE() << grammar.errors()[0].text();
  return {};
}

std::string said(const Result<Word>& word) { return word ? "" : word.errors()[0].text(); }

TEST(Rewrite, DeepDecompositionsNeedNoDeepStack) {
  on_a_small_stack([] {
    // The rest of the successor waits on every level, or on none.
    for (const char* rule : {"A(i) : i > 0 -> A(i-1)B", "A(i) : i > 0 -> BA(i-1)"}) {
      Grammar grammar = grammar_with("A(90000)", {{rule}, {"A(i) -> *"}});
      Result<Word> word = derive(grammar, 1, Seed{1});
      ASSERT_TRUE(word.ok()) << said(word);
      EXPECT_EQ(word->size(), 90000u);
    }
  });
}

TEST(Rewrite, LongDerivationsNeedNoDeepStack) {
  on_a_small_stack([] {
    GrammarText text;
    text.axiom = "A(1,2,3)";
    text.rules = {{"A(x,y,z) -> F(x)A(x,y,z)"}};
    Result<TurtleStats> stats = stats_of(*compile(text), 2000, Seed{1});
    ASSERT_TRUE(stats.ok());
    EXPECT_EQ(stats->segments, 2000u);
  });
}

TEST(Rewrite, DecompositionsThatDoNotEndAreGivenUpWithTheirRule) {
  for (const char* rule : {"F(x) : x > 0 -> F(x+1)X", "F(x) : x > 0 -> XF(x+1)", "F(x) : x > 0 -> F(x+1)",
                           "F(x) : x > 0 -> F(x+1)F(x+1)"}) {
    Grammar grammar = grammar_with("F(1)", {{rule}});
    EXPECT_NE(said(derive(grammar, 1, Seed{1})).find("decomposition rule 1: step 1: `F(x)"),
              std::string::npos);
    EXPECT_FALSE(refuse(forecast(grammar, 1, Seed{1}), {}).empty());
  }
  // Each ends, but there are too many of them, kept or erased.
  for (const char* last : {"F(x) -> X", "F(x) -> *"}) {
    Grammar grammar = grammar_with("F(60)", {{"F(x) : x > 0 -> F(x-1)F(x-1)"}, {last}});
    EXPECT_NE(said(derive(grammar, 1, Seed{1}, {1'000'000, 1 << 30})).find("by decomposition"),
              std::string::npos);
  }
}

TEST(Rewrite, DivisionsByZeroInDecompositionAreTold) {
  Grammar grammar = grammar_with("F(1)", {{"F(x) : x > 0 -> X(1/(x-1))"}});
  EXPECT_EQ(
      said(derive(grammar, 1, Seed{1})).find("decomposition rule 1: step 1: column 20: division by zero"),
      0u);
}

TEST(Rewrite, DivisionsByZeroInInterpretationAreTold) {
  GrammarText text;
  text.axiom = "A(1)";
  text.interpretation = {{"A(x) -> F(1/(x-1))"}};
  Result<TurtleStats> stats = stats_of(*compile(text), 0, Seed{1});
  ASSERT_FALSE(stats.ok());
  EXPECT_EQ(stats.errors()[0].where, "interpretation rule 1");
}

TEST(Rewrite, BytesAreCountedWhileAWordIsDecomposed) {
  Grammar grammar = grammar_with("A(20)", {{"A(i) : i > 0 -> A(i-1)A(i-1)"}, {"A(i) -> B(i,i,i,i,i,i,i,i)"}});
  EXPECT_FALSE(derive(grammar, 1, Seed{1}, {200'000'000, 1'000'000}).ok());
  EXPECT_TRUE(derive(grammar, 1, Seed{1}, {200'000'000, 100'000'000}).ok());
}

}  // namespace
}  // namespace frond
