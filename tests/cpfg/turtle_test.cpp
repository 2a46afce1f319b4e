#include <cmath>
#include <cstdlib>
#include <cstring>

#include "cpfg/model_folder.h"

namespace frond {
namespace {

/// The numbers that a query after a path is filled with: after one step, whose word is the axiom's copy.
std::string answers(const std::string& path, const std::string& view = "angle increment: 90\n",
                    const std::string& rules = "") {
  ModelFiles files(
      {{"m.l", grammar_of("derivation length: 1\nAxiom: " + path + "\nq --> q\n" + rules)}, {"m.v", view}});
  std::string word = word_of(files);
  return word.substr(std::min(word.rfind('?'), word.size()));
}

TEST(CpfgTurtle, PositionsAndAxes) {
  EXPECT_EQ(answers("F(2)f?P(0,0,0)"), "?P(0,3,0)");
  EXPECT_EQ(answers("FF?P(0,0)"), "?P(0,2)");
  EXPECT_EQ(answers("?U(0,0,0)"), "?U(0,0,-1)");
  EXPECT_EQ(answers("?L(0,0,0)"), "?L(-1,0,0)");
  EXPECT_EQ(answers("F[F]?H(0,0,0)"), "?H(0,1,0)");
}

TEST(CpfgTurtle, Turns) {
  auto along = [](const std::string& path) {
    std::string word = answers(path + "F(100)?P(0,0,0)");
    float x = 0, y = 0, z = 0;
    EXPECT_EQ(std::sscanf(word.c_str(), "?P(%f,%f,%f)", &x, &y, &z), 3) << word;
    auto sign = [](float v) { return v > 1 ? "+" : v < -1 ? "-" : "0"; };
    return std::string(sign(x)) + sign(y) + sign(z);
  };
  EXPECT_EQ(along("+"), "-00");
  EXPECT_EQ(along("-"), "+00");
  EXPECT_EQ(along("&"), "00-");
  EXPECT_EQ(along("^"), "00+");
  EXPECT_EQ(along("/+"), "00-");  // left turned toward up
  EXPECT_EQ(along("\\+"), "00+");
  EXPECT_EQ(along("|"), "0-0");
  EXPECT_EQ(along("@R(0,0,5)"), "00+");
  EXPECT_EQ(along("-&(45)@v+"), "-0-");  // left is horizontal again
  EXPECT_EQ(along("@M(0,500,0)"), "0+0");
}

TEST(CpfgTurtle, ScaleAndTropism) {
  EXPECT_EQ(answers("@D(3)F@Di(2)F?P(0,0,0)"), "?P(0,9,0)");
  EXPECT_EQ(answers("F?P(0,0)", "initial scale: 4\n"), "?P(0,4)");
  // Sine 0.5 of 1: the heading turns by 30 degrees toward -z, that is up.
  std::string old = answers("F?H(0,0,0)", "tropism direction: 0,0,-1\ninitial elasticity: 0.5\n");
  EXPECT_EQ(old.substr(0, 17), "?H(0,0.8660254,-0");
  std::string fresh = answers("F?H(0,0,0)", "tropism: T: 1,0,0 A: 0 I: 1 E: 0.5 S: 0\n");
  EXPECT_EQ(fresh.substr(0, 14), "?H(0.47942555,");  // sin(0.5)
}

/// The numbers behind the last query of a word.
std::vector<float> numbers_of(const std::string& word) {
  std::vector<float> numbers;
  for (const char* at = std::strrchr(word.c_str(), '('); at && *at != ')';) {
    char* end = nullptr;
    numbers.push_back(std::strtof(at + 1, &end));
    at = end;
  }
  return numbers;
}

void expect_answer(const std::string& axiom, const std::string& view, std::vector<float> expected) {
  std::vector<float> found = numbers_of(answers(axiom, "angle factor: 4\n" + view));
  ASSERT_EQ(found.size(), expected.size()) << axiom;
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 2e-4f) << axiom << i;
}

TEST(CpfgTurtle, FramesAreCarriedFromTheLastSegment) {
  std::string pull = "tropism: T: 0,1,0 A: 0 I: 1 E: 0.3 S: 0.1\n";
  expect_answer("F/(90)+(60)F?P(0,0,0)", pull, {0, 1.7057f, -0.7085f});
  expect_answer("F/(90)+(60)F?L(0,0,0)", pull, {-1, 0, 0});
  expect_answer("F/(90)+(60)F+(60)F?P(0,0,0)", pull, {-0.7417f, 2.3039f, -1.0119f});
  expect_answer("F&(30)/(90)@Tp?U(0,0,0)", "", {0, -0.5f, -0.8660f});
  expect_answer("F/(90)@R(0,1,0)?U(0,0,0)", "", {1, 0, 0});
  expect_answer("F[/(90)+(60)F]@R(1,0,0)?U(0,0,0)", "", {0, 0, -1});
  expect_answer("@R(1,0)F?P(0,0,0)", "", {1, 0, 0});
}

TEST(CpfgTurtle, TorquesAndStrengths) {
  expect_answer("F?U(0,0,0)", "torque: T: 1,0,0 I: 1 E: 0.5\n", {-0.4794f, 0, -0.8776f});
  // Intensities are held to 1, a line without direction or intensity does not count.
  expect_answer("+(90)F?H(0,0,0)", "tropism: T: 0,0,0 E: 9\ntropism: T: 0,1,0 I: 3 E: 0.5\n",
                {-0.8776f, 0.4794f, 0});
  expect_answer("@Ts(1)@TiF?H(0,0,0)", "tropism: T: 1,0,0 I: 1 E: 0.5 S: 1\n", {0, 1, 0});
  expect_answer("@Ti(1)F?H(0,0,0)", "tropism: T: 1,0,0 I: 1 E: 0 S: 0.5\n", {0.4794f, 0.8776f, 0});
  // The old tropism pulls upward where no direction is given.
  expect_answer("+(90)FF?P(0,0,0)", "initial elasticity: 0.5\n", {-1.8660f, 0.5f, 0});
}

TEST(CpfgTurtle, Quaternions) {
  expect_answer("?Q(9,9,9,9)", "", {0.7071f, 0.7071f, 0, 0});
  expect_answer("?Q(9,9)", "", {0.7071f, 0.7071f});
  // Heading x, left y, up z: no rotation.
  expect_answer("@R(1,0,0,0,0,1)?U(0,0,0)", "", {0, 0, 1});
  expect_answer("?P(9)", "", {0});
}

TEST(CpfgTurtle, PartsScaleWidthsAndLengths) {
  ModelFiles files(
      {{"m.l",
        "Lsystem: 1\nderivation length: 1\nAxiom: @D(5)?(2,0.5)F$F?P(0,0,0)\nq --> q\nendlsystem\n"
        "Lsystem: 2\nAxiom: q\nq --> q\nendlsystem\n"}});
  EXPECT_EQ(numbers_of(word_of(files))[1], 1.5f);  // what @D had set is gone
}

TEST(CpfgTurtle, AnswersComeBeforeAStep) {
  const char* kLines = "derivation length: 1\nAxiom: FA\nA --> F?P(7,7)\n?P(x,y) : y < 5 --> B(y)\n";
  ModelFiles files({{"m.l", grammar_of(kLines)}, {"m.v", "angle factor: 4\n"}});
  EXPECT_EQ(word_of(files), "FF?P(7,7)");
  CpfgRequest two;
  two.steps = 2;
  EXPECT_EQ(word_of(files, two), "FFB(2)");
  files.write("m.v", "environment display: before\n");
  EXPECT_EQ(word_of(files), "FF?P(0,2)");
}

TEST(CpfgTurtle, AHomomorphismWithASeedHasItsOwnStream) {
  auto word = [](const std::string& seed) {
    return word_of(
        ModelFiles({{"m.l", grammar_of("derivation length: 2\nAxiom: X?P(0,0)A\nA --> A(ran(1))\nA(x) --> "
                                       "A(ran(1))\nhomomorphism\n" +
                                       seed + "X --> F(ran(1))")}}));
  };
  // The numbers of drand48 after srand48(1), each time anew; without a seed the stream is that of the
  // productions.
  EXPECT_EQ(word("seed: 1\n").substr(0, 18), "X?P(0,0.041630346)");
  EXPECT_NE(
      word("seed: 1\n").find(word_of("derivation length: 2\nAxiom: A\nA --> A(ran(1))\nA(x) --> A(ran(1))")),
      std::string::npos);
  EXPECT_NE(word("").substr(0, 18), "X?P(0,0.041630346)");
}

TEST(CpfgTurtle, HomomorphismsLeaveWhatIsReadWithAnother) {
  EXPECT_EQ(answers("F?P(9,9,9)", "angle factor: 4\n", "homomorphism\nP(x,y,z) --> G"), "?P(0,1,0)");
  auto drawing = [](const std::string& axiom) {
    return drawing_of(ModelFiles({{"m.l", grammar_of("Axiom: " + axiom +
                                                     "\nq --> q\nhomomorphism\nl --> F\nc --> "
                                                     "F\nG --> F\nX --> ~ll")}}));
  };
  EXPECT_EQ(drawing("~ll@cc@GcG"), "~lF@cF@GcF");
  EXPECT_EQ(drawing("X@X"), "~ll@~ll");
}

TEST(CpfgTurtle, HomomorphismMovesIt) {
  EXPECT_EQ(answers("X?P(0,0)", "angle factor: 4\n", "homomorphism\nX --> F(5)"), "?P(0,5)");
}

}  // namespace
}  // namespace frond
