#include <algorithm>

#include "cpfg/model_folder.h"

namespace frond {
namespace {

CpfgFigure figure_after(const CpfgModel& model, int steps) {
  CpfgRequest request;
  request.steps = steps, request.drawing = true;
  return *draw(model, derive(model, request)->drawing);
}

/// Lines, polygons and spheres that come, move and go.
const char* const kGrowing =
    "Axiom: A(0)\nA(n) : n < 4 --> F(1)[+(50)B(0)]{.f(0.2)+(40)f(0.3).}/(90)A(n+1)\nA(n) --> F(1)@O(n)\n"
    "B(t) : t < 3 --> B(t+1)\nhomomorphism\nB(t) : t > 0 && t < 3 --> F(t)@c(t)\n";

TEST(CpfgBetween, BeginsAndEndsWithTheFigures) {
  Result<CpfgModel> model = read_cpfg("m.l", grammar_of(kGrowing));
  ASSERT_TRUE(model.ok()) << model.errors()[0].text();
  CpfgFigure a = figure_after(*model, 2), b = figure_after(*model, 3);
  EXPECT_EQ(between(a, b, 0).segments.size(), a.segments.size());
  EXPECT_EQ(between(a, b, 1).segments.size(), b.segments.size());
  EXPECT_EQ(between(a, b, 0.5).polygons.size(), 3U);
}

TEST(CpfgBetween, WhatIsNewUnfoldsFromWhatBearsIt) {
  ModelFiles files(
      {{"m.l", grammar_of("Axiom: A\nA --> F(2)[+(90)F@O(1)]A\n")}, {"m.v", "initial line width: 1\n"}});
  Result<CpfgModel> model = read_cpfg(files.path());
  CpfgFigure half = between(figure_after(*model, 1), figure_after(*model, 2), 0.25);
  ASSERT_EQ(half.segments.size(), 4U);
  EXPECT_NEAR(half.segments[2].to.y, 2.5, 1e-9);
  EXPECT_NEAR(half.segments[2].radius_to, 0.125, 1e-9);
  EXPECT_NEAR(half.segments[3].to.x, -0.25, 1e-9);
  EXPECT_NEAR(half.spheres[0].radius, 0.5, 1e-9);
  EXPECT_NEAR(half.spheres[1].radius, 0.125, 1e-9);
}

TEST(CpfgBetween, NothingJumps) {
  Result<CpfgModel> model = read_cpfg("m.l", grammar_of(kGrowing));
  for (int step = 0; step < 7; ++step) {
    CpfgFigure a = figure_after(*model, step), b = figure_after(*model, step + 1), last;
    for (int i = 1; i < 20; ++i) {
      CpfgFigure now = between(a, b, i / 20.0);
      if (i > 1) {
        ASSERT_EQ(now.segments.size(), last.segments.size());
        for (std::size_t k = 0; k < now.segments.size(); ++k) {
          EXPECT_LT(glm::distance(now.segments[k].to, last.segments[k].to), 0.5);
          std::int32_t before = now.segments[k].before;
          ASSERT_LT(before, static_cast<std::int32_t>(k));
          if (before >= 0) {
            EXPECT_EQ(now.segments[static_cast<std::size_t>(before)].to, now.segments[k].from);
          }
        }
        for (std::size_t k = 0; k < now.discs.size(); ++k)
          EXPECT_LT(std::abs(now.discs[k].radius - last.discs[k].radius), 0.1);
      }
      last = std::move(now);
    }
    // The ends are the figures themselves, and what is beside them there has no size.
    CpfgFigure first = between(a, b, 1e-9);
    for (const CpfgSegment& s : a.segments) {
      auto same = [&](const CpfgSegment& other) { return glm::distance(other.to, s.to) < 1e-6; };
      EXPECT_TRUE(std::ranges::any_of(first.segments, same));
    }
  }
}

TEST(CpfgBetween, FilmsFollowTheAnimation) {
  ModelFiles files({{"m.l", grammar_of("derivation length: 3\nAxiom: A\nA --> A")},
                    {"m.a", "first frame: 2\nlast frame: 40\nstep: 5\n"}});
  CpfgFilm film = film_of(*read_cpfg(files.path()), 3);
  EXPECT_EQ(film.first, 2);
  EXPECT_EQ(film.step, 5);
  EXPECT_EQ(film.last, 40);
  files.write("m.a", "last frame: -1\n");
  EXPECT_EQ(film_of(*read_cpfg(files.path()), 3).last, 3);
}

}  // namespace
}  // namespace frond
