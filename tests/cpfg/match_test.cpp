#include "cpfg/model_folder.h"

namespace frond {
namespace {

/// The word after one step, with a production that marks where a context fits.
std::string fits(const std::string& settings, const std::string& axiom, const std::string& context) {
  return word_of("derivation length: 1\n" + settings + "Axiom: " + axiom + "\n" + context +
                 " --> #\nq --> q");
}

TEST(CpfgMatch, LeftContexts) {
  EXPECT_EQ(fits("", "AFAF", "A < F"), "A#A#");
  EXPECT_EQ(fits("", "A[X[Y]]F", "A < F"), "A[X[Y]]#");  // over the branches beside
  EXPECT_EQ(fits("", "A[F[F]]", "A < F"), "A[#[F]]");    // out of the branch, as far as the next module
  EXPECT_EQ(fits("", "AB+F", "AB < F"), "AB+F");
  EXPECT_EQ(fits("ignore: +-\n", "AB+(3)-F", "AB < F"), "AB+(3)-#");
  EXPECT_EQ(fits("consider: AF\n", "AX+F", "A < F"), "AX+#");
  EXPECT_EQ(fits("consider: AF\n", "A[X]F", "A < F"), "A[X]#");  // stays bracketed
  EXPECT_EQ(fits("", "A[F", "[ < F"), "A[F");                    // brackets never match
  EXPECT_EQ(fits("", "A(1)FA(1,2)F", "A(x) < F"), "A(1)#A(1,2)F");
  EXPECT_EQ(fits("", "AF", "* < F > *"), "A#");
}

TEST(CpfgMatch, RightContexts) {
  EXPECT_EQ(fits("", "F[X]D", "F > D"), "#[X]D");
  EXPECT_EQ(fits("", "[F]D", "F > D"), "[F]D");
  EXPECT_EQ(fits("", "F[D]", "F > [D]"), "#[D]");
  EXPECT_EQ(fits("", "F[X][D]", "F > [D]"), "F[X][D]");  // only the first branch
  EXPECT_EQ(fits("", "F[X][D]", "F > [X][D]"), "#[X][D]");
  EXPECT_EQ(fits("", "F[DE]", "F > [D]"), "F[DE]");
  EXPECT_EQ(fits("", "F[D[Q]E]G", "F > [D=]G"), "#[D[Q]E]G");
  EXPECT_EQ(fits("", "F[X]G", "F > [=]G"), "#[X]G");
  EXPECT_EQ(fits("", "F[X][-DY]", "F > [=][-D=]"), "#[X][-DY]");
  EXPECT_EQ(fits("", "F[D[X]]G", "F > [D]G"), "#[D[X]]G");  // a branch before `]` is skipped
  EXPECT_EQ(fits("ignore: +\n", "F+[+D]", "F > [D]"), "#+[+D]");
  EXPECT_EQ(fits("consider: FD\n", "F[X[D]]", "F > D"), "#[X[D]]");  // brackets are ignored, too
  EXPECT_EQ(fits("ignore: []\n", "[F]D", "F > D"), "[#]D");
}

TEST(CpfgMatch, ParametersOfContexts) {
  EXPECT_EQ(
      word_of("derivation length: 1\nAxiom: A(1)F(2)B(4)\nA(x) < F(y) > B(z) : x < y && y < z --> F(x+y+z)"),
      "A(1)F(7)B(4)");
}

TEST(CpfgMatch, Rings) {
  EXPECT_EQ(fits("ring lsystem\n", "FXA", "A < F"), "#XA");
  EXPECT_EQ(fits("", "FXA", "A < F"), "FXA");
  EXPECT_EQ(fits("Ring lsystem\n", "DXF", "F > D"), "DX#");
  EXPECT_EQ(word_of("derivation length: 1\nring lsystem\nAxiom: A(1)A(2)A(3)\nA(l) < A(x) > A(r) --> A(l,r)"),
            "A(3,2)A(1,3)A(2,1)");
  EXPECT_EQ(fits("ring lsystem\n", "F", "A < F"), "F");
}

TEST(CpfgMatch, WhatCannotMatchIsNoted) {
  ModelFiles files({{"m.l", grammar_of("Axiom: A\nA --> B\n[A < B --> C\nA --> D\nB --> E : 2")}});
  Result<CpfgModel> model = read_cpfg(files.path());
  ASSERT_TRUE(model.ok());
  ASSERT_EQ(model->notes.size(), 3u);
  EXPECT_NE(model->notes[0].find("never matches"), std::string::npos);
  EXPECT_NE(model->notes[1].find("comes first"), std::string::npos);
  EXPECT_NE(model->notes[2].find("without `Seed:`"), std::string::npos);
}

}  // namespace
}  // namespace frond
