#include "grammar/turtle.h"

#include <gtest/gtest.h>

#include "grammar/corpus.h"
#include "grammar/square.h"

namespace frond {
namespace {

using nlohmann::json;

GrammarText turtle_grammar(const json& c) {
  json whole = c.contains("grammar") ? c["grammar"] : json::object();
  for (const char* key : {"angle_deg", "draw_as", "turtle_options", "start"})
    if (c.contains(key)) whole[key] = c[key];
  if (c.contains("string")) whole["axiom"] = c["string"];
  return grammar_of(whole);
}

void expect_near(DVec3 got, const json& want, double tolerance, const char* what) {
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(got[i], want[static_cast<std::size_t>(i)].get<double>(), tolerance) << what << " " << i;
}

struct Polygons {
  std::vector<std::vector<DVec3>> found;
  void polygon(std::span<const DVec3> points, const TurtleState&) {
    found.emplace_back(points.begin(), points.end());
  }
};

TEST(Turtle, KnownAnswers) {
  int tried = 0;
  for (const json& c : corpus()) {
    if (c["group"] != "turtle") continue;
    SCOPED_TRACE(c["name"].get<std::string>());
    ++tried;
    Result<Grammar> grammar = compile(turtle_grammar(c));
    ASSERT_TRUE(grammar.ok()) << grammar.errors()[0].text();
    Word word = *derive(*grammar, grammar->text.steps, Seed{1});
    TurtleStats stats = stats_of(*grammar, word, Seed{1});
    const json& e = c["expected"];
    double length = e["total_length"], size = std::max(1.0, length / 100);
    double tolerance = 1e-6 * size;
    EXPECT_EQ(stats.segments, e["segments"].get<std::size_t>());
    EXPECT_EQ(stats.polygons, e["polygons"].get<std::size_t>());
    EXPECT_EQ(stats.max_stack_depth, e["max_stack_depth"].get<int>());
    EXPECT_NEAR(stats.total_length, length, tolerance);
    expect_near(stats.end_position, e["end_position"], tolerance, "position");
    expect_near(stats.end_heading, e["end_heading"], 1e-6, "heading");
    expect_near(stats.end_left, e["end_left"], 1e-6, "left");
    expect_near(stats.end_up, e["end_up"], 1e-6, "up");
    expect_near(stats.low, e["bbox"][0], tolerance, "low");
    expect_near(stats.high, e["bbox"][1], tolerance, "high");
    if (!e.contains("polygon_vertices")) continue;
    Polygons polygons;
    walk(*grammar, word, Seed{1}, polygons);
    ASSERT_EQ(polygons.found.size(), 1u);
    ASSERT_EQ(polygons.found[0].size(), e["polygon_vertices"].size());
    for (std::size_t i = 0; i < polygons.found[0].size(); ++i)
      expect_near(polygons.found[0][i], e["polygon_vertices"][i], 1e-6, "vertex");
  }
  EXPECT_EQ(tried, 25);
}

TEST(Turtle, WidthAndLengthFollowTheDialect) {
  GrammarText text;
  text.axiom = "!F!(0.5)\"F";
  struct Widths {
    std::vector<double> width, length;
    void segment(const Segment& s, TurtleState&) {
      width.push_back(s.width_to), length.push_back(glm::distance(s.from, s.to));
    }
  } abop, houdini;
  Grammar first = std::move(*compile(text));
  walk(first, first.axiom, Seed{1}, abop);
  EXPECT_DOUBLE_EQ(abop.width[0], 0.07);
  EXPECT_DOUBLE_EQ(abop.width[1], 0.5);
  EXPECT_DOUBLE_EQ(abop.length[1], 1.1);
  text.dialect = Dialect::houdini;
  Grammar second = std::move(*compile(text));
  walk(second, second.axiom, Seed{1}, houdini);
  EXPECT_DOUBLE_EQ(houdini.width[1], 0.1 * 0.7 * 0.5);
}

TEST(Turtle, BehindACutNothingIsDrawn) {
  Grammar grammar = grammar_for("F[+F%F[F]F]F");
  EXPECT_EQ(stats_of(grammar, grammar.axiom, Seed{1}).segments, 3u);
}

TEST(Turtle, JitterStaysWithinItsBoundsAndFollowsTheSeed) {
  GrammarText text;
  text.axiom = "F+F+F+F+F+F+F+F";
  text.angle = 10;
  text.angle_jitter = 4;
  text.length_jitter = 0.2;
  struct Steps {
    std::vector<DVec3> steps;
    void segment(const Segment& s, TurtleState&) { steps.push_back(s.to - s.from); }
  } one, same, other;
  Grammar grammar = std::move(*compile(text));
  walk(grammar, grammar.axiom, Seed{1}, one);
  walk(grammar, grammar.axiom, Seed{1}, same);
  walk(grammar, grammar.axiom, Seed{2}, other);
  EXPECT_EQ(one.steps, same.steps);
  EXPECT_NE(one.steps, other.steps);
  for (std::size_t i = 0; i < one.steps.size(); ++i) {
    EXPECT_NEAR(glm::length(one.steps[i]), 1, 0.2);
    if (i == 0) continue;
    double turn = std::acos(glm::dot(glm::normalize(one.steps[i - 1]), glm::normalize(one.steps[i])));
    EXPECT_NEAR(degrees(turn), 10, 4.001);
  }
}

TEST(Figure, TubesJoinTheirPointsOverMoves) {
  auto nodes = [](const std::string& axiom) {
    GrammarText text;
    text.axiom = axiom;
    Grammar grammar = std::move(*compile(text));
    return *skeleton_of(grammar, *derive(grammar, 0, Seed{1}), Seed{1});
  };
  Skeleton tube = nodes("@Gsf@Gc+f@Gcf@Ge");
  ASSERT_EQ(tube.size(), 4u);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(tube.parent[i], static_cast<std::int32_t>(i) - 1);
  // Segments within are not drawn twice, and a branch goes on with the tube of its stem.
  EXPECT_EQ(nodes("@GsF@GcF@Ge").size(), 3u);
  Skeleton forked = nodes("@Gsf@Gc[+f@Ge]f@Ge");
  EXPECT_EQ(forked.parent, (std::vector<std::int32_t>{-1, 0, 1, 1}));
  EXPECT_EQ(nodes("@Gsf@Gef@Gc").size(), 3u);
}

}  // namespace
}  // namespace frond
