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

TEST(CpfgTurtle, HomomorphismMovesIt) {
  EXPECT_EQ(answers("X?P(0,0)", "angle factor: 4\n", "homomorphism\nX --> F(5)"), "?P(0,5)");
}

}  // namespace
}  // namespace frond
