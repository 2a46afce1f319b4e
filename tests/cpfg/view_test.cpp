#include "cpfg/view.h"

#include <cmath>

#include "cpfg/model_folder.h"

namespace frond {
namespace {

const char* kLine = "range: 0 1\npoints: 4\n0 0\n0.25 0.25\n0.75 0.75\n1 1\n";

TEST(CpfgView, FunctionsComeWithinAThousandthOfTheirArgument) {
  Result<cpfg::FunctionTable> line = cpfg::read_function(kLine, 0);
  ASSERT_TRUE(line.ok());
  for (double x : {0.0, 0.1, 0.5, 0.77, 1.0, 3.0}) EXPECT_NEAR((*line)(x), std::min(x, 1.0), 0.001) << x;
  EXPECT_EQ((*line)(0.5), 0.5);
  EXPECT_GT((*line)(0), 0);  // the coarse bound shows
  // With samples values between are linear.
  Result<cpfg::FunctionTable> sampled = cpfg::read_function(kLine, 3);
  EXPECT_EQ((*sampled)(0.25), ((*sampled)(0) + (*sampled)(0.5)) / 2);
}

TEST(CpfgView, BothFormsOfFunctions) {
  Result<cpfg::FunctionTable> fresh = cpfg::read_function(
      "fver 1 1\nname: leaf\nsamples: 5\nmarkers: 1\n0.5 0.5\nflip: off\npoints: 2\n0 2 2\n1 2 1\n", 0);
  ASSERT_TRUE(fresh.ok());
  EXPECT_EQ(fresh->points.size(), 3u);
  EXPECT_EQ(fresh->samples.size(), 5u);
  EXPECT_EQ((*fresh)(0.3), 2);
  EXPECT_FALSE(cpfg::read_function("points: 2\n0 0\n", 0).ok());
  EXPECT_FALSE(cpfg::read_function("", 0).ok());
}

TEST(CpfgView, NumbersOfFunctions) {
  std::string flat = "points: 2\n0 4\n1 4\n";
  ModelFiles files(
      {{"m.l", grammar_of("derivation length: 1\nAxiom: A\nA --> B(func(1,0.5),func(WIDE,0.5),func(3,0.2))")},
       {"m.v", "function: line.func\nfunction set: two.fset\n"},
       {"line.func", kLine},
       {"two.fset", "funcgalleryver 1 1\nitems: 2\nfver 1 1\nname: WIDE\nsamples: 2\n" + flat +
                        "fver 1 1\nname: B1\nsamples: 9\n" + flat}});
  EXPECT_EQ(word_of(files), "B(0.5,4,4)");
  files.write("m.v", "function: line.func\n");
  files.write("m.l", grammar_of("derivation length: 1\nAxiom: A\nA --> B(func(2,0.5))"));
  EXPECT_EQ(word_of(files), "B(0)");
  files.write("m.v", "function: none.func\n");
  EXPECT_EQ(word_of(files), "there is no file \"none.func\" in the model's folder");
}

TEST(CpfgView, CurvesAreMeasured) {
  // Equal steps on a line: the spline from (P0+4P1+P2)/6 to the same of the last three.
  ModelFiles files(
      {{"m.l",
        grammar_of(
            "derivation length: 1\nAxiom: A\nA --> B(curveGAL(1),curveX(1,0.5),curveY(1,1),curveZ(1,0))")},
       {"m.v", "curve: line.con\n"},
       {"line.con", "cver 1 1\nname: line\npoints: 4 4\ntype: or\n0 0 7 1\n1 1 7 1\n2 2 7 1\n3 3 7 1\n"}});
  std::string word = word_of(files);
  float length = 0, x = 0, y = 0, z = 0;
  ASSERT_EQ(std::sscanf(word.c_str(), "B(%f,%f,%f,%f)", &length, &x, &y, &z), 4) << word;
  EXPECT_NEAR(length, std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(x, 1.5, 1e-5);
  EXPECT_NEAR(y, 2, 1e-5);
  EXPECT_NEAR(z, 7, 1e-5);
}

TEST(CpfgView, ClosedCurvesComeBack) {
  Result<cpfg::ContourFile> round = cpfg::read_contour(
      "version: 1.4\ncontact: 0 0 0\nsize: 1\npoints: 4\nrange: 0 1\ndimension: 2\ntype: bspline-closed\n1 0 "
      "0 1\n0 1 0 1\n-1 0 0 1\n0 -1 0 1\n");
  ASSERT_TRUE(round.ok());
  cpfg::CurveTable curve = cpfg::measure(*round, 200);
  EXPECT_NEAR(curve(0)[0], curve(1)[0], 1e-9);
  EXPECT_NEAR(curve(0)[1], curve(1)[1], 1e-9);
}

TEST(CpfgView, FilesOfAModel) {
  std::string grammar = grammar_of("Axiom: A\nA --> B");
  ModelFiles files({{"m.l", grammar}, {"m.v", ""}, {"o.v", ""}, {"o.a", ""}, {"x.map", ""}});
  Result<CpfgModel> model = read_cpfg(files.path());
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->files.view.filename(), "m.v");
  EXPECT_EQ(model->files.animation.filename(), "o.a");  // the only one
  files.write("specifications", "menu\ncpfg -m x.map m.l o.v\n");
  model = read_cpfg(files.path());
  EXPECT_EQ(model->files.view.filename(), "o.v");
  ASSERT_EQ(model->files.colours.size(), 1u);
  files.write("specifications", "cpfg -e light.e m.l o.v\n");
  EXPECT_NE(word_of(files).find("environment"), std::string::npos);
}

TEST(CpfgView, LinesGoThroughThePreprocessor) {
  ModelFiles files(
      {{"m.l", grammar_of("Axiom: A\nA --> B")},
       {"m.v", "#define A 30\nangle increment: A // degrees\nno key\ntropism: T: 0,1,0\n\tE: 0.5\n"}});
  Result<CpfgModel> model = read_cpfg(files.path());
  ASSERT_TRUE(model.ok());
  ASSERT_EQ(model->view.size(), 2u);
  EXPECT_EQ(model->view[0].key, "angle increment");
  EXPECT_EQ(model->view[0].value, "30");
  EXPECT_EQ(model->view[1].value, "T: 0,1,0 E: 0.5");
}

TEST(CpfgView, WhatIsNotDrawnIsNoted) {
  ModelFiles files({{"m.l", grammar_of("Axiom: F\nq --> q")},
                    {"m.v", "line: F leaf.s 1\ntexture: F: bark.rgb\ninitial line width: 2\n"}});
  Result<CpfgModel> model = read_cpfg(files.path());
  ASSERT_TRUE(model.ok());
  ASSERT_EQ(model->notes.size(), 2U);
  EXPECT_NE(model->notes[0].find("m.v: line 1: lines are drawn round"), std::string::npos) << model->notes[0];
  EXPECT_NE(model->notes[1].find("textures are not drawn"), std::string::npos) << model->notes[1];
}

}  // namespace
}  // namespace frond
