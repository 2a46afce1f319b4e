#include "grammar/between.h"

#include <gtest/gtest.h>

#include "grammar/corpus.h"
#include "grammar/figure.h"

namespace frond {
namespace {

/// What a camera sees of a shape: its box, its length, where it ends, how wide it is.
struct Shape {
  DVec3 low{1e30}, high{-1e30};
  double length = 0, area = 0;
  void segment(const Segment& s, TurtleState&) {
    low = glm::min(low, glm::min(s.from, s.to)), high = glm::max(high, glm::max(s.from, s.to));
    length += glm::distance(s.from, s.to);
    area += glm::distance(s.from, s.to) * (s.width_from + s.width_to) / 2;
  }
};

double difference(const Shape& a, const Shape& b) {
  double size = std::max(1.0, glm::distance(a.low, a.high));
  return (glm::distance(a.low, b.low) + glm::distance(a.high, b.high)) / size +
         std::abs(a.length - b.length) / std::max(1.0, a.length) +
         std::abs(a.area - b.area) / std::max(1.0, a.area);
}

TEST(Between, PassesWholeStepsWithoutAJump) {
  for (const char* name :
       {"abop-1.24a", "abop-1.24d", "abop-1.24f", "wikipedia-koch", "abop-1.10a-dragon", "abop-2.6a-honda",
        "abop-2.8d-tropism-tree", "seed-coral", "abop-1.27", "abop-eq1.10"}) {
    for (const auto& c : corpus()) {
      if (c["name"] != name) continue;
      SCOPED_TRACE(name);
      Grammar grammar = std::move(*compile(grammar_of(c)));
      for (int step = 1; step < 5; ++step) {
        Shape at, below, above;
        ASSERT_TRUE(draw_between(grammar, step, Seed{1}, at).ok());
        ASSERT_TRUE(draw_between(grammar, step - 1e-4, Seed{1}, below).ok());
        ASSERT_TRUE(draw_between(grammar, step + 1e-4, Seed{1}, above).ok());
        if (at.length == 0) continue;
        EXPECT_LT(difference(at, below), 1e-4) << "before step " << step;
        EXPECT_LT(difference(at, above), 1e-4) << "after step " << step;
        Shape half, more;
        ASSERT_TRUE(draw_between(grammar, step + 0.5, Seed{1}, half).ok());
        ASSERT_TRUE(draw_between(grammar, step + 0.501, Seed{1}, more).ok());
        EXPECT_LT(difference(half, more), 0.05) << "within step " << step;
      }
    }
  }
}

TEST(Between, FigureHasASoundSkeleton) {
  GrammarText text;
  text.rules = {{"F -> F[+F~K]F!"}};
  Grammar grammar = std::move(*compile(text));
  Result<Figure> figure = figure_of(grammar, 2.25, Seed{1});
  ASSERT_TRUE(figure.ok());
  EXPECT_EQ(figure->skeleton.find_fault(), "");
  EXPECT_LT(figure->sites.back().scale.x, 1);
  EXPECT_FALSE(figure_of(grammar, -1, Seed{1}).ok());
}

}  // namespace
}  // namespace frond
