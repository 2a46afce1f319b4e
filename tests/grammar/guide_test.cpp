#include "grammar/guide.h"

#include <gtest/gtest.h>

#include "grammar/between.h"
#include "grammar/corpus.h"

namespace frond {
namespace {

/// Where each symbol took each of the turtles.
struct Places {
  std::vector<DVec3> drawn;
  void segment(const Segment& s, TurtleState&) { drawn.push_back(s.to); }
};

double nearest(const std::vector<DVec3>& places, DVec3 to) {
  double least = 1e300;
  for (DVec3 place : places) least = std::min(least, glm::distance(place, to));
  return least;
}

Places walk_of(const GrammarText& text, Seed seed = Seed{1}) {
  Grammar grammar = std::move(*compile(text));
  Places places;
  walk(grammar, *derive(grammar, text.steps, seed), seed, places);
  return places;
}

/// A stem of eight, which forks and forks again.
GrammarText bush() {
  GrammarText g;
  g.axiom = "A(40)";
  g.steps = 41;
  g.rules = {{"A(n) : n > 0 -> F[+(40)F(0.1)]?A(n-1)"}};
  g.guide.points = {{{0, 0, 0}},     {{0, 1, 0}},      {{1, 2, 0}},      {{-1, 2, 0.5}},
                    {{1.5, 3, 0.5}}, {{1.2, 2.8, -1}}, {{-1.6, 2.4, 1}}, {{0, 2.5, -1}}};
  g.guide.parent = {-1, 0, 1, 1, 2, 2, 3, 1};
  g.guide.reach_ends = true;
  g.guide.tolerance = 0.02;
  return g;
}

TEST(Guide, KnownAnswer) {
  int tried = 0;
  for (const nlohmann::json& c : corpus()) {
    if (c["group"] != "data-guided") continue;
    ++tried;
    Grammar grammar = std::move(*compile(grammar_of(c)));
    const nlohmann::json& e = c["expected"];
    Word word = *derive(grammar, grammar.text.steps, Seed{1});
    TurtleStats stats = stats_of(grammar, word, Seed{1});
    EXPECT_EQ(stats.segments, e["segments"].get<std::size_t>());
    ASSERT_EQ(stats.end_positions.size(), e["turtles_at_end"].get<std::size_t>());
    for (std::size_t i = 0; i < stats.end_positions.size(); ++i)
      EXPECT_LT(glm::distance(stats.end_positions[i], point_of(e["end_positions"][i])), 1e-6);
    // The turtles after each symbol: the word cut there.
    for (std::size_t length = 1; length <= word.size(); ++length) {
      Word head;
      head.symbols.assign(word.symbols.begin(), word.symbols.begin() + static_cast<std::ptrdiff_t>(length));
      TurtleStats there = stats_of(grammar, head, Seed{1});
      const nlohmann::json& places = e["positions_after_each_symbol"][length - 1];
      ASSERT_EQ(there.end_positions.size(), places.size()) << length;
      for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_LT(glm::distance(there.end_positions[i], point_of(places[i])), 1e-6) << length;
    }
  }
  EXPECT_GE(tried, 1);
}

TEST(Guide, BezierOfAnyDegree) {
  std::vector<DVec3> line{{0, 0, 0}, {2, 0, 0}}, cubic{{0, 0, 0}, {5, 0, 0}, {5, 0, 5}, {0, 0, 5}};
  EXPECT_EQ(bezier_point(line, 0.25), DVec3(0.5, 0, 0));
  for (double t : {0.0, 0.3, 0.5, 1.0}) {
    double s = 1 - t;
    DVec3 bernstein =
        s * s * s * cubic[0] + 3 * s * s * t * cubic[1] + 3 * s * t * t * cubic[2] + t * t * t * cubic[3];
    EXPECT_LT(glm::distance(bezier_point(cubic, t), bernstein), 1e-12);
  }
  std::vector<DVec3> seventh(8, DVec3(1, 2, 3));
  EXPECT_LT(glm::distance(bezier_point(seventh, 0.4), DVec3(1, 2, 3)), 1e-12);
}

TEST(Guide, HandlesBendTheWayBetweenPoints) {
  GuideText text;
  text.points = {{{0, 0, 0}}, {{4, 0, 0}, 0}, {{4, 4, 0}, 1}, {{8, 0, 0}, 1}};
  std::size_t straight = guide_of(text)->points.size();
  EXPECT_EQ(straight, 4u);
  text.points[1].out = DVec3(3, 0, 0);  // of both its ways on; the handle before it is opposite
  Guide guide = *guide_of(text);
  std::vector<DVec3> places;
  for (std::size_t i = 0; i < guide.points.size(); ++i) {
    places.push_back(guide.points[i].at);
    EXPECT_LT(guide.points[i].parent, static_cast<std::int32_t>(i));
  }
  for (const GuidePoint& point : text.points) EXPECT_EQ(nearest(places, point.at), 0);
  std::vector<DVec3> control{{4, 0, 0}, {7, 0, 0}, {4, 4, 0}, {4, 4, 0}};
  EXPECT_LT(nearest(places, bezier_point(control, 0.5)), 1e-12);
  EXPECT_EQ(guide.leaves(), 2u) << "it forks where it did";
}

TEST(Guide, TrunkPassesEachPointOfTheCurve) {
  for (double leniency : {0.5, 0.8, 1.0}) {
    GrammarText palm;
    palm.axiom = "T(200)C";
    palm.steps = 201;
    palm.length = 0.2;
    palm.rules = {{"T(n) : n > 0 -> F?T(n-1)"}, {"C -> [+(60)F][-(60)F]"}};
    palm.guide.bezier = {{0, 0, 0}, {5, 0, 0}, {5, 0, 5}, {0, 0, 5}};
    palm.guide.samples = 20;
    palm.guide.tolerance = 0.05;
    palm.guide.leniency = leniency;
    palm.guide.reach_ends = true;
    Places places = walk_of(palm);
    for (int i = 0; i <= 20; ++i)
      EXPECT_LE(nearest(places.drawn, bezier_point(palm.guide.bezier, i / 20.0)), 0.05) << i;
  }
}

TEST(Guide, BranchAtEachLeafPoint) {
  GrammarText text = bush();
  Places places = walk_of(text);
  for (std::size_t i = 0; i < text.guide.points.size(); ++i)
    EXPECT_LE(nearest(places.drawn, text.guide.points[i].at), text.guide.tolerance) << i;
  // What lies between is the grammar's own: a twig a step, one for each of the turtles.
  Grammar grammar = std::move(*compile(text));
  TurtleStats stats = stats_of(grammar, *derive(grammar, text.steps, Seed{1}), Seed{1});
  EXPECT_EQ(stats.end_positions.size(), 4u);
  EXPECT_GT(stats.segments, 200u);
}

TEST(Guide, SteersWithTheGrammarsOwnTurns) {
  GrammarText text = bush();
  text.rules = {{"A(n) : n > 0 -> F/(90)+(rand(-12,12))F?A(n-1)"}};
  text.axiom = "A(120)";
  text.steps = 121;
  text.guide.leniency = 0.3;
  text.guide.tolerance = 0.1;
  Places places = walk_of(text);
  for (const GuidePoint& point : text.guide.points)
    EXPECT_LE(nearest(places.drawn, point.at), 0.1) << point.at.x << " " << point.at.y;
}

TEST(Guide, StreamedAsStoredAndTheSameEachTime) {
  GrammarText text = bush();
  text.angle_jitter = 4;
  Grammar grammar = std::move(*compile(text));
  ASSERT_TRUE(can_stream(grammar, text.steps));
  Places streamed, stored = walk_of(text), again = walk_of(text), other = walk_of(text, Seed{2});
  ASSERT_TRUE(draw(grammar, text.steps, Seed{1}, streamed).ok());
  EXPECT_EQ(streamed.drawn, stored.drawn);
  EXPECT_EQ(again.drawn, stored.drawn);
  EXPECT_NE(other.drawn, stored.drawn);
}

TEST(Guide, TurtlesThatForkWithinABranchEndWithIt) {
  GrammarText text;
  text.axiom = "?[F?FF]G";  // the fork at (0,1,0) lies inside of the brackets
  text.guide.points = {{{0, 1, 0}}, {{1, 2, 0}}, {{-1, 2, 0}}};
  text.guide.parent = {-1, 0, 0};
  text.guide.leniency = 1;
  text.steps = 0;
  Grammar grammar = std::move(*compile(text));
  TurtleStats stats = stats_of(grammar, grammar.axiom, Seed{1});
  EXPECT_EQ(stats.segments, 1u + 2 * 2 + 1);
  ASSERT_EQ(stats.end_positions.size(), 1u);
  EXPECT_LT(glm::distance(stats.end_positions[0], DVec3(0, 1, 0)), 1e-12);
  EXPECT_EQ(figure_of(grammar, grammar.axiom, Seed{1}).skeleton.find_fault(), "");
}

TEST(Guide, PointsSetWhatTheTurtleDrawsWith) {
  GrammarText text;
  text.axiom = "F?F?F+F";
  text.steps = 0;
  text.width = 0.2;
  text.tropism = {0, -1, 0};
  text.guide.points = {
      {.at = {0, 1, 0}, .radius = 0.03, .angle = 30.0, .elasticity = 0.5, .tropism = DVec3(1, 0, 0)},
      {.at = {0, 2, 0}, .parent = 0}};
  text.guide.leniency = 1;
  struct Widths {
    std::vector<double> width;
    std::vector<double> angle;
    DVec3 last{0};
    void segment(const Segment& s, TurtleState& t) {
      width.push_back(s.width_to), angle.push_back(t.angle), last = glm::normalize(s.to - s.from);
    }
  } sink;
  Grammar grammar = std::move(*compile(text));
  walk(grammar, grammar.axiom, Seed{1}, sink);
  EXPECT_EQ(sink.width[0], 0.2);
  EXPECT_NEAR(sink.width[1], 0.06, 1e-12);
  EXPECT_EQ(sink.angle[1], 30.0);
  // +(30) alone would give x = -0.5; the pull at the point is toward +x and not down.
  EXPECT_GT(sink.last.x, -0.45);
}

/// The nodes that a grammar with a guide draws.
Skeleton drawn_along(std::vector<GuidePoint> points, double leniency, const std::string& axiom,
                     double width = 0.5) {
  GrammarText text;
  text.axiom = axiom;
  text.steps = 0;
  text.width = width;
  text.guide.points = std::move(points);
  text.guide.leniency = leniency;
  text.guide.tolerance = 1e-6;
  text.guide.reach_ends = true;
  Grammar grammar = std::move(*compile(text));
  return figure_of(grammar, grammar.axiom, Seed{1}).skeleton;
}

TEST(Guide, TheFirstPointKeepsItsRadius) {
  std::vector<GuidePoint> line = {{.at = {0, 0, 0}, .radius = 0.06},
                                  {.at = {0, 1, 0}, .parent = 0, .radius = 0.05},
                                  {.at = {1, 2, 0}, .parent = 1, .radius = 0.02}};
  Skeleton whole = drawn_along(line, 1, "?F?F");
  ASSERT_EQ(whole.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FLOAT_EQ(whole.radius[i], static_cast<float>(*line[i].radius));
  // Half of the way has half of the change.
  Skeleton half = drawn_along(line, 0.5, "?F");
  EXPECT_FLOAT_EQ(half.radius[0], 0.06f);
  EXPECT_FLOAT_EQ(half.radius[1], 0.055f);
  // A first point that lies ahead is come to from the turtle's own width.
  line[0].at = {0, -1, 0};
  Skeleton ahead = drawn_along(line, 1, "?F?F?F", 0.14);
  EXPECT_FLOAT_EQ(ahead.radius[0], 0.07f);
  EXPECT_FLOAT_EQ(ahead.radius[1], 0.06f);
  // What the grammar says behind the ? counts, and so does a move.
  line[0].at = {0, 0, 0};
  EXPECT_FLOAT_EQ(drawn_along(line, 1, "?!(0.2)F").radius[0], 0.1f);
  EXPECT_FLOAT_EQ(drawn_along(line, 0.5, "?fF").radius[0], 0.055f);
}

TEST(Guide, EachOfSeveralFirstPointsKeepsItsRadius) {
  std::vector<GuidePoint> stems = {{.at = {0, 0, 0}, .radius = 0.06},
                                   {.at = {0, 1, 0}, .parent = 0, .radius = 0.03},
                                   {.at = {0, 0, 2}, .radius = 0.04},
                                   {.at = {0, 1, 2}, .parent = 2, .radius = 0.01}};
  Skeleton drawn = drawn_along(stems, 1, "?f?F");
  ASSERT_EQ(drawn.size(), 4u);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    bool found = false;
    for (const GuidePoint& stem : stems)
      found |= glm::distance(drawn.position[i], Vec3(stem.at)) < 1e-6f &&
               std::abs(drawn.radius[i] - static_cast<float>(*stem.radius)) < 1e-6f;
    EXPECT_TRUE(found) << i << " is " << drawn.radius[i] << " thick";
  }
}

TEST(Guide, BranchesAtAForkBeginAsThickAsIt) {
  std::vector<GuidePoint> fork = {{.at = {0, 0, 0}, .radius = 0.06},
                                  {.at = {1, 1, 0}, .parent = 0, .radius = 0.02},
                                  {.at = {-1, 1, 0}, .parent = 0, .radius = 0.03}};
  Skeleton drawn = drawn_along(fork, 1, "?F");
  for (std::size_t i = 0; i < drawn.size(); ++i)
    if (drawn.parent[i] == Skeleton::kRoot) {
      EXPECT_FLOAT_EQ(drawn.radius[i], 0.06f);
    }
}

TEST(Guide, CurvesBetweenPointsTaperEvenly) {
  GuideText text;
  text.points = {{.at = {0, 0, 0}, .out = DVec3(0, 1, 0), .radius = 0.06},
                 {.at = {2, 2, 0}, .parent = 0, .in = DVec3(-1, 0, 0), .radius = 0.02}};
  Guide guide = *guide_of(text);
  ASSERT_GT(guide.points.size(), 6u);
  double last = 0.06, most = 0;
  for (const GuidePoint& point : guide.points) {
    ASSERT_TRUE(point.radius);
    EXPECT_LE(*point.radius, last);
    most = std::max(most, last - *point.radius);
    last = *point.radius;
  }
  EXPECT_DOUBLE_EQ(last, 0.02);
  EXPECT_LT(most, 0.04 / 6);
}

TEST(Guide, SeveralFirstPointsMakeSeveralTurtles) {
  GrammarText text;
  text.axiom = "?FF";
  text.steps = 0;
  text.guide.points = {{{3, 0, 0}}, {{-3, 0, 0}}, {{0, 0, 3}}};
  text.guide.parent = {-1, -1, -1};
  Grammar grammar = std::move(*compile(text));
  EXPECT_EQ(stats_of(grammar, grammar.axiom, Seed{1}).end_positions.size(), 3u);
}

TEST(Guide, LinesBecomeTrees) {
  GuideLines lines{{{0, 0, 0}, {0, 1, 0}, {1, 2, 0}, {-1, 2, 0}, {0, 1, 0}, {9, 9, 9}, {8, 8, 8}},
                   {{0, 1}, {4, 3}, {1, 2}, {2, 3}, {5, 6}}};  // place 4 is place 1; a circle over 2-3
  std::vector<GuidePoint> points = points_of(lines);
  ASSERT_EQ(points.size(), 6u);
  int roots = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    roots += points[i].parent < 0;
    EXPECT_LT(points[i].parent, static_cast<int>(i));
  }
  EXPECT_EQ(roots, 2);
  EXPECT_EQ(points[0].at, DVec3(0, 0, 0));
  EXPECT_EQ(points[1].parent, 0);
}

TEST(Guide, WhatCannotBeFollowedIsTold) {
  auto error = [](auto change) {
    GrammarText text = bush();
    change(text);
    Result<Grammar> grammar = compile(text);
    return grammar ? std::string("none") : grammar.errors()[0].text();
  };
  EXPECT_EQ(error([](GrammarText&) {}), "none");
  EXPECT_NE(error([](GrammarText& g) { g.guide.parent = {-1, 0, 3, 2, 2, 2, 3, 1}; }).find("circle"),
            std::string::npos);
  EXPECT_NE(error([](GrammarText& g) { g.guide.parent[3] = 8; }).find("parent of point 3"),
            std::string::npos);
  EXPECT_NE(error([](GrammarText& g) { g.guide.parent.pop_back(); }).find("7 numbers for 8"),
            std::string::npos);
  EXPECT_NE(error([](GrammarText& g) {
              g.guide.bezier = {{0, 0, 0}, {1, 1, 1}};
            }).find("one of"),
            std::string::npos);
  EXPECT_NE(error([](GrammarText& g) { g.rules = {{"A(n) -> F"}}; }).find("`?`"), std::string::npos);
}

TEST(Guide, ForecastCountsAllTurtles) {
  Grammar grammar = std::move(*compile(bush()));
  Forecast size = forecast(grammar, grammar.text.steps, Seed{1}, {});
  auto drawn = static_cast<double>(walk_of(bush()).drawn.size());
  EXPECT_GE(size.segments, drawn);
  EXPECT_NE(size.kind, Forecast::Kind::exact);
}

TEST(Guide, GrowsBetweenSteps) {
  Grammar grammar = std::move(*compile(bush()));
  for (double steps : {3.25, 17.5, 30.9}) {
    Places places;
    ASSERT_TRUE(draw_between(grammar, steps, Seed{1}, places).ok());
    EXPECT_GT(places.drawn.size(), 3u);
  }
}

}  // namespace
}  // namespace frond
