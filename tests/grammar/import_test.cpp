#include "grammar/import.h"

#include <gtest/gtest.h>

#include "grammar/figure.h"

namespace frond {
namespace {

std::string derived(const Import& import) {
  Result<Grammar> grammar = compile(import.grammar);
  if (!grammar) return grammar.errors()[0].text();
  return text(*grammar, *derive(*grammar, import.grammar.steps, Seed{import.grammar.seed}));
}

TEST(Import, CpfgProductionsAndSettings) {
  Result<Import> import = import_cpfg(
      "#define N 2\n#define R (1/2)\n/* a comment\n over lines */\nlsystem: 1\nseed: 7\nderivation length: "
      "N\n"
      "ignore: +-\naxiom: A(4)\nA(x) : x > 1 --> F(x)[+A(x*R)]A(x*R)\nF(x) --> G(x) : 1\nB < C > D --> *\n"
      "homomorphism\nmaximum depth: 2\nG(x) --> F(x)\nendlsystem\n");
  ASSERT_TRUE(import.ok()) << import.errors()[0].text();
  EXPECT_EQ(import->grammar.steps, 2);
  EXPECT_EQ(import->grammar.ignore, "+-");
  EXPECT_EQ(import->grammar.interpretation_depth, 2);
  ASSERT_EQ(import->grammar.rules.size(), 3u);
  EXPECT_EQ(derived(*import), "G(4)[+F(2)[+A(1)]A(1)]F(2)[+A(1)]A(1)");
  EXPECT_EQ(import->notes.size(), 1u);
  EXPECT_FALSE(import_cpfg("nothing").ok());
}

TEST(Import, CpfgSaysWhatIsLeftOut) {
  Result<Import> import =
      import_cpfg("lsystem: 1\nStart: {x = 1;}\naxiom: A\nA : {y = 2;} 1 --> B\nA --> @PS(1)F(ran(2)) : 3\n");
  ASSERT_TRUE(import.ok());
  EXPECT_EQ(import->notes.size(), 4u);
  ASSERT_EQ(import->grammar.rules.size(), 1u);
  EXPECT_EQ(import->grammar.rules[0].text, "A ->(3) @PS(1)F(rand(0,2))");
}

TEST(Import, LParserAlphabet) {
  Result<Import> import = import_lparser("# a bush\n1\n30\n20\n>Aa\n\nA=Z<(20)F[%!'A]\na=F~(10)\n@\nrest");
  ASSERT_TRUE(import.ok()) << import.errors()[0].text();
  EXPECT_EQ(import->grammar.angle, 30);
  EXPECT_DOUBLE_EQ(import->grammar.width, 0.2);
  EXPECT_EQ(derived(*import), "/Z\\(20)F[/(180)@w(0.7)\"(0.9)A]F@~(10)");
  Grammar grammar = std::move(*compile(import->grammar));
  EXPECT_DOUBLE_EQ(stats_of(grammar, 1, Seed{1})->total_length, 2.5);
}

TEST(Import, HoudiniRules) {
  Result<Import> import = import_houdini(
      "premise: A(0)\nangle: 28\ngenerations: 3\nb: "
      "2\nA(i):i<2=F(i*b)[+A(i+1)]:0.5\nA(i):i==2=K\nF(l)=F(l+1)\nnonsense\n");
  ASSERT_TRUE(import.ok()) << import.errors()[0].text();
  EXPECT_EQ(import->grammar.dialect, Dialect::houdini);
  EXPECT_EQ(derived(*import), "F(2)[+F(3)[+K]]");
  EXPECT_EQ(import->notes.size(), 2u);
}

std::string said(const Result<Import>& import) { return import ? "" : import.errors()[0].text(); }

TEST(Import, NumbersThatNoCountCanHoldAreRefused) {
  for (std::string length : {"1e300", "-1", "nan", "1e6+1", "N", "2*", ""})
    EXPECT_NE(said(import_cpfg("#define M 2\nderivation length: " + length + "\naxiom: A\nA --> AA\n"))
                  .find("line 2: `derivation length:"),
              std::string::npos)
        << length;
  EXPECT_EQ(
      import_cpfg("#define M 2\n#define N (M+1)\nderivation length: 2*N+0.9\naxiom: A\n")->grammar.steps, 6);
  EXPECT_NE(said(import_cpfg("axiom: A\nseed: 1e300\n")).find("line 2: `seed: 1e300`"), std::string::npos);
  EXPECT_NE(said(import_cpfg("axiom: A\nhomomorphism\nmaximum depth: 1e10\n")).find("line 3"),
            std::string::npos);
  EXPECT_NE(said(import_lparser("1e99\n30\n20\nA\nA=FA\n")).find("line 1: `1e99`"), std::string::npos);
  EXPECT_NE(said(import_lparser("inf\n30\n20\nA\nA=FA\n")).find("are numbers"), std::string::npos);
  EXPECT_NE(said(import_houdini("generations: 1e300\nA=FA\n")).find("line 1: `generations"),
            std::string::npos);
  EXPECT_NE(said(import_houdini("seed: -5\nA=FA\n")).find("line 1: `seed"), std::string::npos);
}

}  // namespace
}  // namespace frond
