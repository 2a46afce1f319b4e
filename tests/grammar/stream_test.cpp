#include "grammar/stream.h"

#include <gtest/gtest.h>

#include "grammar/corpus.h"

namespace frond {
namespace {

/// Writes down all that a turtle does.
struct Events {
  std::vector<double> log;
  void add(DVec3 v) { log.insert(log.end(), {v.x, v.y, v.z}); }
  void segment(const Segment& s, TurtleState& t) {
    add(s.from), add(s.to), log.push_back(s.width_to), log.push_back(t.color);
  }
  void push(TurtleState& t) { log.push_back(t.depth); }
  void pop(TurtleState& t) { add(t.position); }
  void polygon(std::span<const DVec3> points, const TurtleState&) {
    for (DVec3 p : points) add(p);
  }
};

/// A random grammar without contexts: some rules draw lots, some have parameters and conditions.
GrammarText random_grammar(Seed seed) {
  const std::vector<std::string> pieces{"F", "+", "-", "&", "/", "A", "B", "F(2)", "C(1)", "!", "G", "f"};
  auto word = [&](Seed s, bool inner) {
    std::string out;
    int open = 0;
    for (std::uint64_t i = 0; i < 2 + s.bits() % 5; ++i) {
      std::uint64_t pick = s.child(i).bits() % (pieces.size() + 2);
      if (pick == pieces.size())
        out += "[", ++open;
      else if (pick == pieces.size() + 1 && open > 0)
        out += "]", --open;
      else if (pick < pieces.size())
        out += inner && pieces[pick] == "C(1)" ? "C(x/2+rand(0,1))" : pieces[pick];
    }
    while (open-- > 0) out += "]";
    return out;
  };
  GrammarText g;
  g.axiom = "AB" + word(seed.child("axiom"), false);
  g.angle_jitter = seed.child("jitter").bits() % 2 ? 5 : 0;
  g.rules = {{"A -> " + word(seed.child(1), false)},
             {"B ->(0.5) " + word(seed.child(2), false)},
             {"B ->(1) " + word(seed.child(3), false)},
             {"C(x) : x > 0.6 -> " + word(seed.child(4), true)}};
  if (seed.child(9).bits() % 2) g.interpretation = {{"B -> ~F+(3)"}, {"A ->(1) F"}, {"A ->(2) FF"}};
  return g;
}

TEST(Stream, GivesTheTurtleWhatIsStored) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Result<Grammar> grammar = compile(random_grammar(Seed{i}));
    ASSERT_TRUE(grammar.ok()) << grammar.errors()[0].text();
    ASSERT_TRUE(can_stream(*grammar, 5));
    Events streamed, stored;
    Result<TurtleState> end = draw(*grammar, 5, Seed{i}, streamed);
    ASSERT_TRUE(end.ok()) << end.errors()[0].text();
    walk(*grammar, *derive(*grammar, 5, Seed{i}), Seed{i}, stored);
    ASSERT_EQ(streamed.log, stored.log) << "grammar " << i;
  }
}

TEST(Stream, KeepsBracketsBalanced) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Grammar grammar = std::move(*compile(random_grammar(Seed{i})));
    int depth = 0;
    Word word = *derive(grammar, 5, Seed{i});
    for (SymbolId symbol : word.symbols) {
      depth += symbol == grammar.open ? 1 : symbol == grammar.close ? -1 : 0;
      ASSERT_GE(depth, 0);
    }
    EXPECT_EQ(depth, 0);
  }
}

}  // namespace
}  // namespace frond
