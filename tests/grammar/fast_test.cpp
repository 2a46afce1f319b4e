#include "grammar/fast.h"

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "grammar/corpus.h"

namespace frond {
namespace {

Word plainly(const Grammar& grammar, int steps, Seed seed) {
  Derivation state = begin(grammar, seed);
  EXPECT_TRUE(advance_plainly(grammar, state, steps, seed).empty());
  return state.word;
}

TEST(Fast, SameWordAsTheGeneralWay) {
  for (const auto& c : corpus()) {
    if (!c.contains("rules") || c["group"] == "turtle") continue;
    SCOPED_TRACE(c["name"].get<std::string>());
    Grammar grammar = std::move(*compile(grammar_of(c)));
    for (int steps = 0; steps <= c["n"].get<int>(); steps += 1 + steps / 4)
      EXPECT_TRUE(plainly(grammar, steps, Seed{3}) == *derive(grammar, steps, Seed{3})) << steps;
  }
}

TEST(Fast, EveryWayIsTheOneMeant) {
  auto named = [](std::string_view name) {
    for (const auto& c : corpus())
      if (c["name"] == name) return std::move(*compile(grammar_of(c)));
    return Grammar{};
  };
  EXPECT_TRUE(is_fixed(named("algae")));
  Grammar hogeweg = named("abop-1.31b-hogeweg-hesper");
  EXPECT_TRUE(NeighbourTable(hogeweg).fits());
  Word out;
  for (const char* name : {"abop-1.27", "abop-2.6a-honda", "seed-bush"}) {
    Grammar grammar = named(name);
    EXPECT_TRUE(step_free(grammar, begin(grammar, Seed{1}), out, Seed{1}, {}).has_value()) << name;
  }
}

GrammarText large(int which) {
  GrammarText text;
  text.axiom = which == 2 ? "A(1,2)" : "AB";
  if (which == 0) text.rules = {{"A -> A[+B]BA"}, {"B -> AB"}, {"+ -> *"}};
  if (which == 1) text.rules = {{"A ->(1) A[+B]BA"}, {"A ->(2) BABABABABA"}, {"B ->(0.3) AB"}, {"B ->(1) B"}};
  if (which == 2)
    text.rules = {{"A(x,y) -> B(x*0.9,rand(0,y))[+(y)A(y,x)]A(x,y/2)"}, {"B(x,y) -> B(x+y,x)F(x)"}};
  if (which == 3) {
    text.axiom = "A(1)A(2)";
    text.rules = {{"A(x) < A(y) > A(z) : y > 1 -> A(y-0.1)[B(x)A(z+rand(0,1))]A(y-0.1)"},
                  {"B(x) < A(y) ->(0.5) A(x+y)B(x)A(1)"},
                  {"B(x) < A(y) ->(0.5) A(2)"},
                  {"A(x) ->(1) A(x+0.5)A(x)"},
                  {"A(x) ->(1) A(x)"}};
  }
  return text;
}

TEST(Fast, SameWordOnOneThreadAndMany) {
  for (int which = 0; which < 4; ++which) {
    Grammar grammar = std::move(*compile(large(which)));
    int steps = which == 0 ? 14 : which == 1 ? 9 : which == 2 ? 15 : 16;
    // Many first: threads that were held back from the start are not called later.
    Word many = *derive(grammar, steps, Seed{4});
    limit_threads(1);
    Word one = *derive(grammar, steps, Seed{4});
    limit_threads(0);
    EXPECT_GT(one.size(), 100'000u);
    EXPECT_TRUE(one == many) << which;
    EXPECT_TRUE(one == plainly(grammar, steps, Seed{4})) << which;
  }
}

TEST(Fast, ChunksAreAsGoodAsTheWhole) {
  Grammar grammar = std::move(*compile(large(3)));
  Derivation whole = begin(grammar, Seed{4});
  std::vector<std::uint32_t> parents;
  for (int i = 0; i < 16; ++i) ASSERT_TRUE(advance_tracked(grammar, whole, Seed{4}, parents).empty());
  EXPECT_TRUE(whole.word == *derive(grammar, 16, Seed{4}));
}

TEST(Fast, LeftmostStepsDoNotDependOnTheLength) {
  GrammarText text;
  text.mode = GrammarText::Mode::sequential;
  text.axiom = "xS(1)y";
  text.rules = {{"S(k) ->(1) aS(k+1)b"}, {"S(k) ->(2) a(k)S(k)"}};
  Grammar grammar = std::move(*compile(text));
  ASSERT_TRUE(is_leftmost(grammar));
  EXPECT_TRUE(plainly(grammar, 500, Seed{1}) == *derive(grammar, 500, Seed{1}));
  EXPECT_EQ(plainly(grammar, 500, Seed{1}).size(), derive(grammar, 500, Seed{1})->size());
  EXPECT_GT(derive(grammar, 500'000, Seed{1})->size(), 500'000u);
}

TEST(Fast, TroubleIsNamedAllTheSame) {
  GrammarText text;
  text.axiom = "FFA(2)";
  text.rules = {{"A(x) -> A(1/(x-1))B(x)"}, {"B(x) -> B(1/(x-2))"}};
  Grammar grammar = std::move(*compile(text));
  Result<Word> word = derive(grammar, 2, Seed{1});
  ASSERT_FALSE(word.ok());
  EXPECT_NE(word.errors()[0].text().find("rule 1: step 2, module 3 (`A(1)`)"), std::string::npos)
      << word.errors()[0].text();
}

}  // namespace
}  // namespace frond
