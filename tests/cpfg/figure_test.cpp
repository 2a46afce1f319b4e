#include <algorithm>
#include <array>
#include <cmath>

#include "core/seed.h"
#include "cpfg/model_folder.h"

namespace frond {
namespace {

/// What the axiom draws with a view; the axiom stays as it is.
CpfgFigure figure_of(const ModelFiles& files) {
  CpfgRequest request;
  request.drawing = true;
  Result<CpfgModel> model = read_cpfg(files.path());
  EXPECT_TRUE(model.ok()) << model.errors()[0].text();
  if (!model) return {};
  Result<CpfgDerived> derived = derive(*model, request);
  EXPECT_TRUE(derived.ok()) << derived.errors()[0].text();
  if (!derived) return {};
  Result<CpfgFigure> figure = draw(*model, derived->drawing);
  EXPECT_TRUE(figure.ok()) << figure.errors()[0].text();
  return figure ? *figure : CpfgFigure{};
}

CpfgFigure drawn(const std::string& axiom, const std::string& view = "") {
  ModelFiles files({{"m.l", grammar_of("Axiom: " + axiom + "\nq --> q")},
                    {"m.v", "angle increment: 90\ninitial line width: 0.2 cylinders\n" + view}});
  return figure_of(files);
}

void expect_at(DVec3 found, DVec3 expected, double within = 1e-6) {
  EXPECT_LT(glm::distance(found, expected), within)
      << found.x << ' ' << found.y << ' ' << found.z << " is not " << expected.x << ' ' << expected.y << ' '
      << expected.z;
}

TEST(CpfgFigure, LinesGoOnFromEachOther) {
  CpfgFigure figure = drawn("FG(2)[+F]f(3)F(-1)g");
  ASSERT_EQ(figure.segments.size(), 4U);
  expect_at(figure.segments[1].to, {0, 3, 0});
  expect_at(figure.segments[2].to, {-1, 3, 0});
  expect_at(figure.segments[3].from, {0, 6, 0});
  expect_at(figure.segments[3].to, {0, 5, 0});
  EXPECT_EQ(figure.segments[0].before, -1);
  EXPECT_EQ(figure.segments[1].before, 0);
  EXPECT_EQ(figure.segments[2].before, 1);
  EXPECT_EQ(figure.segments[2].depth, 1);
  EXPECT_EQ(figure.segments[3].before, -1);  // f leaves a gap
  expect_at(figure.end, {0, 6, 0});
  EXPECT_EQ(figure.max_stack_depth, 1);
}

TEST(CpfgFigure, WidthsAreDiametersAndTaper) {
  CpfgFigure figure = drawn("!(4)F!(2)F[!(1)F]F");
  ASSERT_EQ(figure.segments.size(), 4U);
  EXPECT_EQ(figure.segments[0].radius_from, 2);
  EXPECT_EQ(figure.segments[0].radius_to, 1);
  EXPECT_EQ(figure.segments[1].radius_to, 1);  // the width within the branch comes after its `[`
  EXPECT_EQ(figure.segments[2].radius_from, 0.5);
  EXPECT_EQ(figure.segments[3].radius_from, 1);
  EXPECT_EQ(drawn("!(4)F!(2)F", "tapered lines: off\n").segments[0].radius_to, 2);
  // A line ends at an @ and not at a point.
  EXPECT_EQ(drawn("!(2)F@Tx(0)!(0.1)f").segments[0].radius_to, 1);
  EXPECT_NEAR(drawn("!(2)F.!(0.1)F").segments[0].radius_to, 0.05, 1e-6);
}

TEST(CpfgFigure, WidthSteps) {
  std::string view = "line width increment: 0.05\n";
  EXPECT_NEAR(drawn("!F", view).segments[0].radius_from, 0.075, 1e-9);
  EXPECT_NEAR(drawn("##F", view).segments[0].radius_from, 0.15, 1e-9);
  EXPECT_NEAR(drawn("!!!!!!!!F", view).segments[0].radius_from, 0.5e-7, 1e-12);
  // A width is scaled when it is set; @D changes those that come after it.
  EXPECT_NEAR(drawn("@D(3)F!(1)F").segments[0].radius_from, 0.1, 1e-9);
  EXPECT_NEAR(drawn("@D(3)F!(1)F").segments[1].radius_from, 1.5, 1e-9);
  EXPECT_NEAR(drawn("F", "initial scale: 4\n").segments[0].radius_from, 0.1, 1e-9);
  // In pixels of a window of 600 that the figure fills, also where the view says nothing.
  EXPECT_NEAR(drawn("F(300)", "initial line width: 0.2 p\n").segments[0].radius_from, 0.05, 1e-9);
  EXPECT_NEAR(drawn("F(300)", "line style: pixel\n").segments[0].radius_from, 0.05, 1e-9);
}

TEST(CpfgFigure, ColorsCountAndWrap) {
  auto color = [](const std::string& word) {
    return drawn(word + "F", "initial color: 2\ncolor increment: 3\n").segments[0].color;
  };
  EXPECT_EQ(color(""), 2);
  EXPECT_EQ(color(";"), 5);
  EXPECT_EQ(color(",,"), 252);
  EXPECT_EQ(color(";(7)"), 7);
  EXPECT_EQ(color(",(300)"), 44);
  EXPECT_EQ(color("[;(9)]"), 2);
  EXPECT_EQ(color("@;(9)"), 2);  // the back side
  EXPECT_EQ(drawn("F", "initial line width: 1\n").segments[0].color, 128);
}

TEST(CpfgFigure, PolygonsNest) {
  CpfgFigure figure = drawn("{.f-f-{.+F+F.};(3)G-f}");
  ASSERT_EQ(figure.polygons.size(), 2U);
  const CpfgPolygon &inner = figure.polygons[0], &outer = figure.polygons[1];
  ASSERT_EQ(inner.points.size(), 3U);
  expect_at(inner.points[0], {1, 1, 0});
  expect_at(inner.points[1], {2, 1, 0});
  expect_at(inner.points[2], {2, 2, 0});
  EXPECT_EQ(inner.color, 128);
  ASSERT_EQ(outer.points.size(), 4U);  // G makes none
  expect_at(outer.points[2], {1, 1, 0});
  expect_at(outer.points[3], {3, 3, 0});
  EXPECT_EQ(outer.color, 128);  // that at its first point
  EXPECT_EQ(figure.segments.size(), 3U);
  EXPECT_TRUE(drawn("{F}F}").polygons.empty());
}

TEST(CpfgFigure, DiscsSpheresAndRings) {
  CpfgFigure figure = drawn("f&@o(2)@c(4)@O(6)@O");
  ASSERT_EQ(figure.discs.size(), 2U);
  expect_at(figure.discs[0].normal, {0, 0, 1});
  EXPECT_EQ(figure.discs[0].radius, 1);
  expect_at(figure.discs[1].center, {0, 1, 0});
  expect_at(figure.discs[1].normal, {0, -1, 0});  // `&` turns the heading toward -z, so up looks down
  ASSERT_EQ(figure.spheres.size(), 2U);
  EXPECT_EQ(figure.spheres[0].radius, 3);
  EXPECT_NEAR(figure.spheres[1].radius, 0.1, 1e-9);
  CpfgFigure ring = drawn("@bc(2)");
  ASSERT_EQ(ring.segments.size(), 24U);
  for (const CpfgSegment& s : ring.segments) {
    EXPECT_NEAR(glm::length(s.from), 1, 1e-9);
    EXPECT_NEAR(s.from.z, 0, 1e-9);
  }
  EXPECT_EQ(drawn("@bo(2)").segments.size(), 24U);
}

TEST(CpfgFigure, RoundCylindersAreSegments) {
  CpfgFigure figure = drawn("!(2)@Gsf(3)!(1)@Gc(2)[-f@Gc]f(3)@Ge");
  ASSERT_EQ(figure.segments.size(), 2U + 4 + 4);
  expect_at(figure.segments[1].to, {0, 3, 0});
  EXPECT_NEAR(figure.segments[0].to.y, 1.5, 1e-9);
  EXPECT_NEAR(figure.segments[0].radius_to, 0.75, 1e-9);
  EXPECT_EQ(figure.segments[2].before, 1);
  EXPECT_EQ(figure.segments[6].before, 1);  // after the branch the main cylinder goes on
  expect_at(figure.segments[5].to, {1, 3, 0});
  expect_at(figure.segments[9].to, {0, 6, 0});
}

TEST(CpfgFigure, TangentsAndSlopes) {
  // Hermite's curve from (0,0) heading up to (2,2) heading right, tangents as long as 1.2 of the distance.
  CpfgFigure figure = drawn("@Gsf(2)-f(2)@Ge(2)");
  double tangent = 1.2 * std::sqrt(8.0);
  expect_at(figure.segments[0].to, {1 - tangent / 8, 1 + tangent / 8, 0});
  expect_at(drawn("@Gt(0,0)@Gsf(2)-f(2)@Ge(2)").segments[0].to, {1, 1, 0});
  EXPECT_EQ(drawn("@Gt(0)@Gsf(2)-f(2)@Ge(2)").segments[0].to,
            drawn("@Gt(0,0)@Gsf(2)-f(2)@Ge(2)").segments[0].to);
  // A tangent (cos 45, sin 45) of share and radius at the beginning, and an even one at the end: at 1/2 the
  // share is 1/2 + (cos 45 - 1) / 8 and the radius 0.1 + sin 45 / 8.
  CpfgFigure rising = drawn("@Gr(0,0,45,1)@Gsf(4)@Ge(2)");
  EXPECT_NEAR(rising.segments[0].radius_to, 0.1 + std::sqrt(0.5) / 8, 1e-6);
  EXPECT_NEAR(rising.segments[0].to.y, 1.8681, 1e-4);
  EXPECT_NEAR(drawn("@Gr(0,0,45,1)@Gr(1)@Gsf(4)@Ge(2)").segments[0].radius_to, 0.1 + std::sqrt(0.5) / 2,
              1e-6);
}

TEST(CpfgFigure, CurvesBetweenBraces) {
  // What stands behind } says only that it is no polygon; strips are told behind { or by a point.
  EXPECT_EQ(drawn("{(1).f(2)f(2)}(1)").segments.size(), 8U);
  EXPECT_EQ(drawn("{(1,6).f(2)f(2)}(1)").segments.size(), 12U);
  EXPECT_EQ(drawn("{(1).f(2)g(2).(3)}(1)").segments.size(), 7U);
  EXPECT_EQ(drawn("{(2,3).f(2)-f(2)}(2)").segments.size(), 9U);
  // Branches go on from where the curve was, and so does it after them.
  CpfgFigure branched = drawn("{(1,1).f(2)[+f(2)]f(2)}(1)");
  ASSERT_EQ(branched.segments.size(), 3U);
  expect_at(branched.segments[1].to, {-2, 2, 0});
  expect_at(branched.segments[2].from, {0, 2, 0});
  // An open B-spline has a span for each point after the third, from (P0 + 4 P1 + P2) / 6 on.
  EXPECT_TRUE(drawn("{(3).f(2)f(2)}(3)").segments.empty());
  CpfgFigure open = drawn("{(3).f(2)f(2)f(2)}(3)");
  ASSERT_EQ(open.segments.size(), 4U);
  expect_at(open.segments.front().from, {0, 2, 0});
  expect_at(open.segments.back().to, {0, 4, 0});
  CpfgFigure closed = drawn("{(4).f(2)-f(2)-f(2)}(4)");
  EXPECT_EQ(closed.segments.size(), 16U);
  expect_at(closed.segments.front().from, closed.segments.back().to);
}

const char* const kStrip =
    "cver 1 2\nname: strip\npoints: 4 4\ntype: or\n-1 -1 0 1\n-1 0 0 1\n-1 1 0 1\n-1 2 0 1\n";

TEST(CpfgFigure, ContoursBecomeSkins) {
  ModelFiles files({{"m.l", grammar_of("Axiom: @#(2)!(2)@Gsf(4);(5)@Gc(4)f(4)@Ge(4)\nq --> q")},
                    {"m.v", "contour: 2 c.con\ncontour sides: 6\ninitial color: 5\nline style: cylinder\n"},
                    {"c.con", kStrip}});
  CpfgFigure figure = figure_of(files);
  EXPECT_TRUE(figure.segments.empty());
  ASSERT_EQ(figure.skins.size(), 1U);  // one colour
  const Surface& mesh = figure.skins[0].mesh;
  EXPECT_EQ(mesh.position.size(), 9U * 7);
  EXPECT_EQ(mesh.triangle.size(), 8U * 6 * 2);
  EXPECT_EQ(mesh.find_fault(), "");
  for (const Vec3& p : mesh.position) {
    EXPECT_NEAR(p.z, 1, 1e-6);  // x of the contour lies along up, -z
    EXPECT_LE(std::abs(p.x), 1.001);
  }
  EXPECT_NEAR(mesh.position[0].x, 0, 1e-6);  // y = 0 at the beginning of the open spline
  EXPECT_NEAR(mesh.position[6].x, 0.9,
              1e-6);  // against left; of an open one the last tenth of a span is missing
  files.write("m.l", grammar_of("Axiom: @#(2)@Gsf(4)@Gc(4)f(4);@Ge(4)\nq --> q"));
  EXPECT_EQ(figure_of(files).skins.size(), 2U);
}

const char* const kPatch =
    "0 3 0 3 0 0\nPRECISION S: 3 T: 3\nCONTACT POINT X: 0 Y: 0 Z: 0\nEND POINT X: 0 Y: 3 Z: 0\n"
    "HEADING X: 0 Y: 1 Z: 0\nUP X: 0 Y: 0 Z: 1\nSIZE: 3\nleaf\nTOP COLOR: 1 DIFFUSE: 0\nBOTTOM COLOR: 1\n"
    "AL: ~ A: ~ AR: ~\nL: ~ R: ~\nBL: ~ B: ~ BR: ~\n"
    "0 0 0 1 0 0 2 0 0 3 0 0\n0 1 0 1 1 0 2 1 0 3 1 0\n0 2 0 1 2 0 2 2 0 3 2 0\n0 3 1 1 3 1 2 3 1 3 3 1\n";

TEST(CpfgFigure, SurfacesAreLaidOnTheTurtle) {
  ModelFiles files({{"m.l", grammar_of("Axiom: f;(4)~l(2)F~l(1,2,3)\nq --> q")},
                    {"m.v", "surface: l leaf.s 6\n"},
                    {"leaf.s", kPatch}});
  CpfgFigure figure = figure_of(files);
  ASSERT_EQ(figure.placed.size(), 2U);
  expect_at(figure.placed[0].position, {0, 1, 0});
  expect_at(figure.placed[0].factors, {2, 2, 2});
  EXPECT_EQ(figure.placed[0].color, 4);
  expect_at(figure.segments[0].from, {0, 13, 0});  // its end is 6 on, twice
  expect_at(figure.placed[1].factors, {1, 2, 3});
  const Surface& leaf = figure.surfaces.at('l');
  EXPECT_EQ(leaf.position.size(), 16U);
  EXPECT_EQ(leaf.triangle.size(), 18U);
  EXPECT_EQ(leaf.find_fault(), "");
  expect_at(DVec3(leaf.position.back()), {6, 6, 2});  // x along left, y along heading, z along up
  // Left is -x and up is -z at the start.
  expect_at(figure.low, {-12, 1, -6});
}

TEST(CpfgFigure, ContoursBeginAlongUpAndAreEven) {
  // Round a triangle-like curve whose beginning, (0, 1.667), is turned onto up.
  ModelFiles files(
      {{"m.l", grammar_of("Axiom: @#(1)!(2)@Gsf(4)@Ge(1)\nq --> q")},
       {"m.v", "contour: 1 c.con\nline style: cylinder\n"},
       {"c.con", "cver 1 2\nname: c\npoints: 4 4\ntype: cr\n-3 -1 0 1\n0 3 0 1\n3 -1 0 1\n0 -1 0 1\n"}});
  CpfgFigure figure = figure_of(files);
  ASSERT_EQ(figure.skins.size(), 1U);
  const Surface& mesh = figure.skins[0].mesh;
  ASSERT_EQ(mesh.position.size(), 16U);
  // Along up, which is -z, and against left, which is x.
  const std::array<Vec2, 5> expected{
      {{1.667, 0}, {1.111, -1.184}, {0.014, -1.933}, {-0.925, -1.334}, {-1, 0}}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(-mesh.position[i].z, expected[i].x, 0.02) << i;
    EXPECT_NEAR(mesh.position[i].x, expected[i].y, 0.02) << i;
  }
}

TEST(CpfgFigure, ContoursOfTheOldestForm) {
  ModelFiles files({{"m.l", grammar_of("Axiom: @#(1)!(2)@Gsf(4)@Ge(1)\nq --> q")},
                    {"m.v", "contour: 1 c.con\nline style: cylinder\n"},
                    {"c.con", "4 2 closed\n1 0\n0 1\n-1 0\n0 -1\n"}});
  CpfgFigure figure = figure_of(files);
  ASSERT_EQ(figure.skins.size(), 1U);
  EXPECT_EQ(figure.skins[0].mesh.position.size(), 16U);
}

TEST(CpfgFigure, SurfacesHaveAxesOfTheirOwn) {
  std::string turned = kPatch;
  turned.replace(turned.find("HEADING X: 0 Y: 1"), 17, "HEADING X: 1 Y: 0");
  ModelFiles files({{"m.l", grammar_of("Axiom: ~l(1,9)\nq --> q")},
                    {"m.v", "surface: l leaf.s 3 1 2\nsurface: l other.s 1\n"},
                    {"leaf.s", turned},
                    {"other.s", kPatch}});
  CpfgFigure figure = figure_of(files);
  expect_at(figure.placed[0].factors, {1, 1, 1});
  EXPECT_EQ(figure.surfaces.at('l').triangle.size(), 4U);  // one piece down the rows, two along them
  expect_at({figure.low.x, figure.low.y, 0}, {-3, -3, 0});
  expect_at({figure.high.x, figure.high.y, 0}, {0, 0, 0});
}

TEST(CpfgFigure, WhatMeansNothingBehindAnAtIsReadForItself) {
  EXPECT_EQ(drawn("@FF@XF").segments.size(), 3U);
  EXPECT_EQ(drawn("F?(7)$F", "line width increment: 1\n").segments.size(), 2U);
}

TEST(CpfgFigure, TrianglesAndWhatIsMissing) {
  ModelFiles files({{"m.l", grammar_of("Axiom: ~t\nq --> q")},
                    {"m.v", "tsurface: t t.tri 2\n"},
                    {"t.tri", "triangle\n0 0 0\n1 0 0\n0 1 0\n"}});
  EXPECT_EQ(figure_of(files).surfaces.at('t').triangle.size(), 1U);
  auto wrong = [&] {
    Result<CpfgModel> model = read_cpfg(files.path());
    CpfgRequest request;
    request.drawing = true;
    Result<CpfgFigure> figure = draw(*model, derive(*model, request)->drawing);
    return figure ? std::string() : figure.errors()[0].what;
  };
  files.write("t.tri", "nothing");
  EXPECT_EQ(wrong(), "t.tri: no patch and no triangle with an area");
  files.write("m.v", "surface: t leaf.s\n");
  EXPECT_EQ(wrong(), "");  // a surface that is not there is not drawn
  std::vector<std::string> notes = read_cpfg(files.path())->notes;
  EXPECT_TRUE(
      std::ranges::any_of(notes, [](auto& note) { return note.find("~t draws nothing") != note.npos; }));
  files.write("leaf.s", "1 2 3\n");
  EXPECT_EQ(wrong(), "leaf.s: found 3 numbers; expected 6 bounds, and 48 for each patch");
  files.write("m.v", "");
  files.write("m.map", "short");
  EXPECT_EQ(wrong(), "found 5 bytes; expected a colour map of 768");
}

TEST(CpfgFigure, ColorsOfMapsAndMaterials) {
  std::string map(768, '\0');
  map[3 * 7] = '\xff';
  ModelFiles files({{"m.l", grammar_of("Axiom: F\nq --> q")}, {"m.map", map}});
  EXPECT_EQ(figure_of(files).colors[7], (Color{1, 0, 0}));
  std::string record(15, '\0');
  record[0] = 9, record[6] = '\x33', record[9] = '\x33';  // diffuse and emitted green
  files.write("m.mat", record);
  files.write("specifications", "cpfg -M m.mat m.l\n");
  EXPECT_EQ(figure_of(files).colors[9], (Color{0, 0.4f, 0}));
  EXPECT_EQ(figure_of(files).colors.size(), 256U);
  files.write("specifications", "cpfg -m1 m.map -m2 m.map m.l\n");
  EXPECT_EQ(figure_of(files).colors.size(), 512U);
  EXPECT_EQ(figure_of(files).colors[256 + 7], (Color{1, 0, 0}));
}

TEST(CpfgFigure, SurfacesMoveTheTurtleOfQueries) {
  ModelFiles files({{"m.l", grammar_of("derivation length: 1\nAxiom: ~l(2)?P(0,0,0)\nq --> q")},
                    {"m.v", "surface: l leaf.s 6\n"},
                    {"leaf.s", kPatch}});
  EXPECT_EQ(word_of(files), "~l(2)?P(0,12,0)");
  files.write("leaf.s", "");
  EXPECT_EQ(word_of(files), "step 1: leaf.s: found 0 numbers; expected 6 bounds, and 48 for each patch");
}

TEST(CpfgFigure, CutsAndSkips) {
  EXPECT_EQ(drawn("F[F@mc(1)F[F]F]F").segments.size(), 3U);
  EXPECT_EQ(drawn("F[F@mc(0)F]F").segments.size(), 4U);
  EXPECT_EQ(drawn("F[F%F]F").segments.size(), 4U);
  EXPECT_EQ(drawn("F[F%F]F", "interpretation past %: off\n").segments.size(), 3U);
}

/// A word of all that the turtle knows.
std::string random_word(Seed seed) {
  static const std::vector<std::string> kSymbols{
      "F",   "f",   "G",   "g",   "[",   "]",   "{",   "}",   ".",   "+",   "&",   "/",
      "|",   "!",   "#",   ";",   "_",   "@Gs", "@Gc", "@Ge", "@Gt", "@Gr", "@#",  "@!",
      "@O",  "@o",  "@c",  "@b",  "~l",  "~",   "@R",  "@M",  "@v",  "@D",  "@Di", "@Ts",
      "@Ti", "@Tx", "@Tp", "@Tf", "@mc", "@PS", "@",   "%",   "@L",  "@bc", "@,",  ","};
  static const std::vector<std::string> kNumbers{"1", "2", "-3", "0", "0.5", "45", "10^30", "100", "-10^38"};
  std::string word;
  for (std::uint64_t i = 0, n = seed.child("count").bits() % 60; i < n; ++i) {
    Seed own = seed.child("symbol", i);
    word += kSymbols[own.bits() % kSymbols.size()];
    for (std::uint64_t k = 0, count = own.child("values").bits() % 7; k < count; ++k) {
      word += k == 0 ? '(' : ',';
      word += kNumbers[own.child("number", k).bits() % kNumbers.size()];
      if (k + 1 == count) word += ')';
    }
  }
  return word.empty() ? "F" : word;
}

TEST(CpfgFuzz, AnyWordIsDrawnOrRefused) {
  ModelFiles files(
      {{"m.v",
        "line style: cylinder\ncontour: 1 c.con\nsurface: l leaf.s 2\ntropism: T: 1,1,0 I: 1 E: 0.3\n"
        "torque: T: 0,0,1 I: 1 E: 0.2\ntwist of cylinders: on\n"},
       {"c.con", kStrip},
       {"leaf.s", kPatch}});
  int right = 0;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    Result<CpfgModel> model =
        read_cpfg(files.path(), grammar_of("Axiom: " + random_word(Seed{i}) + "\nq --> q"));
    ASSERT_TRUE(model.ok()) << model.errors()[0].text();
    CpfgRequest request;
    request.drawing = true;
    Result<CpfgDerived> derived = derive(*model, request);
    ASSERT_TRUE(derived.ok());
    Result<CpfgFigure> figure = draw(*model, derived->drawing);
    if (!figure) continue;
    ++right;
    auto in_order = [&](std::int32_t segment, std::size_t end) {
      return segment < static_cast<std::int32_t>(end);
    };
    for (std::size_t k = 0; k < figure->segments.size(); ++k) {
      const CpfgSegment& s = figure->segments[k];
      ASSERT_TRUE(in_order(s.before, k));
      ASSERT_TRUE(s.radius_from >= 0 && s.radius_to >= 0 && s.color >= 0 && s.color < 256);
      if (s.before >= 0) {
        ASSERT_EQ(figure->segments[static_cast<std::size_t>(s.before)].to, s.from);
      }
    }
    for (const CpfgSkin& skin : figure->skins) ASSERT_TRUE(in_order(skin.segment, figure->segments.size()));
    for (const CpfgPolygon& polygon : figure->polygons) ASSERT_GE(polygon.points.size(), 3U);
  }
  EXPECT_GT(right, 300);
}

TEST(CpfgFigure, WalksTooFar) {
  ModelFiles files({{"m.l", grammar_of("Axiom: @D(1000000)A\nderivation length: 4\nA --> F(10^9)AA")}});
  Result<CpfgModel> model = read_cpfg(files.path());
  CpfgRequest request;
  request.drawing = true;
  Result<CpfgFigure> figure = draw(*model, derive(*model, request)->drawing);
  ASSERT_FALSE(figure.ok());
  EXPECT_NE(figure.errors()[0].what.find("beyond all that can be drawn"), std::string::npos);
}

}  // namespace
}  // namespace frond
