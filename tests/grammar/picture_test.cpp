#include "grammar/picture.h"

#include <gtest/gtest.h>

#include "grammar/corpus.h"

namespace frond {
namespace {

std::size_t times(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

Grammar named(std::string_view name) {
  for (const auto& c : corpus())
    if (c["name"] == name) return std::move(*compile(grammar_of(c)));
  return {};
}

TEST(Picture, TreeHasALineFromEachModuleToItsParent) {
  Grammar grammar = named("algae");
  std::string svg = *derivation_tree_svg(grammar, 5, Seed{1});
  // Words of 1, 2, 3, 5, 8 and 13 letters, and a number for each of the six rows.
  EXPECT_EQ(times(svg, "<text"), 32u + 6u);
  EXPECT_EQ(times(svg, "<line"), 31u);
  EXPECT_TRUE(derivation_tree_svg(named("cut-shedding"), 6, Seed{1}).ok());
  EXPECT_TRUE(derivation_tree_svg(named("decomp-fib"), 1, Seed{1}).ok());
  EXPECT_FALSE(derivation_tree_svg(named("abop-1.24a"), 6, Seed{1}).ok());
}

TEST(Picture, TrackedStepsMakeTheSameWord) {
  for (const auto& c : corpus()) {
    if (!c.contains("rules") || c["group"] == "turtle" || c["expected"].value("modules", 100000) > 10000)
      continue;
    SCOPED_TRACE(c["name"].get<std::string>());
    Grammar grammar = std::move(*compile(grammar_of(c)));
    Derivation state = begin(grammar, Seed{2});
    std::vector<std::uint32_t> parents;
    for (int i = 0; i < c["n"].get<int>(); ++i) {
      std::size_t before = state.word.size();
      ASSERT_TRUE(advance_tracked(grammar, state, Seed{2}, parents).empty());
      ASSERT_EQ(parents.size(), state.word.size());
      for (std::uint32_t parent : parents) ASSERT_LT(parent, before);
    }
    EXPECT_TRUE(state.word == *derive(grammar, c["n"], Seed{2}));
  }
}

TEST(Picture, TurtleDrawsPathsAndPolygons) {
  GrammarText text;
  text.axiom = "F[+F]'-F{.f+f.}";
  Grammar grammar = std::move(*compile(text));
  std::string svg = *turtle_svg(grammar, 0, Seed{1});
  EXPECT_EQ(times(svg, "<path"), 2u);
  EXPECT_EQ(times(svg, "<polygon"), 1u);
  EXPECT_NE(svg.find("viewBox=\"0 0 "), svg.npos);
}

}  // namespace
}  // namespace frond
