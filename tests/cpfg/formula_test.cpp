#include <cmath>

#include "cpfg/chance.h"
#include "cpfg/model_folder.h"

namespace frond {
namespace {

/// What a formula is as the axiom's parameter.
std::string value_of(const std::string& formula) { return word_of("Axiom: A(" + formula + ")\nA --> A"); }

TEST(CpfgFormula, Values) {
  for (auto [formula, value] : std::vector<std::pair<std::string, std::string>>{
           {"2^3^2", "64"},       {"-2^2", "4"},         {"7-2-1", "4"},     {"2+3*4", "14"},
           {"8/4/2", "1"},        {"7.9%3.9", "1"},      {"5/0", "5"},       {"1 < 2 < 3", "1"},
           {"3 > 2 > 1", "0"},    {"1<>2", "1"},         {"2!=2", "0"},      {"!0+1", "2"},
           {"1||0&&0", "1"},      {"1?2:3", "2"},        {"0?2:0?3:4", "4"}, {"3.", "3"},
           {".5", "0.5"},         {"1.5e2", "150"},      {"unknown", "0"},   {"sin(90)", "1"},
           {"cos(180)", "-1"},    {"atan(1)", "45"},     {"asin(1)", "90"},  {"log(exp(2))", "2"},
           {"sqrt(16)", "4"},     {"floor(-1.5)", "-2"}, {"ceil(1.2)", "2"}, {"trunc(1.5)", "2"},
           {"trunc(-1.5)", "-1"}, {"fabs(-3)", "3"},     {"sign(-3)", "-1"}, {"--3", "3"},
           {"2-(3-4)", "3"},      {"10-2^2*2+1", "3"}})
    EXPECT_EQ(value_of(formula), "A(" + value + ")") << formula;
}

TEST(CpfgFormula, WhatCpfgDoesNotHaveIsRefused) {
  for (auto [formula, said] :
       std::vector<std::pair<std::string, std::string>>{{"min(1,2)", "no function `min`"},
                                                        {"atan2(1,2)", "cannot call"},
                                                        {"1e3", "found `e3)`"},
                                                        {"+1", "found `+1)`"},
                                                        {"sin(1,2)", "2 arguments"},
                                                        {"fscanf(1)", "reads numbers"},
                                                        {"vvXmin(0)", "window"},
                                                        {"(1", "expected `,` or `)`"},
                                                        {"x=1", "found `=1)`"}})
    EXPECT_NE(value_of(formula).find(said), std::string::npos) << formula << ": " << value_of(formula);
}

TEST(CpfgFormula, OnlyWhatIsNeededIsEvaluated) {
  // A skipped draw leaves the stream where it was.
  std::string skipped = word_of(
      "Start: {srand(1); a = 0 && ran(1); b = 1 || ran(1); c = 1 ? 2 : ran(1);}\nAxiom: A(ran(1))\nA --> A");
  EXPECT_EQ(skipped, word_of("Start: {srand(1);}\nAxiom: A(ran(1))\nA --> A"));
}

TEST(CpfgFormula, IsAStatementForWhatItsCallsDo) {
  for (const char* statement : {"-x;", "x;", "(x);", "5;", "a[1];", "x == 3;", "x ? 1 : 2;", "!x; -x;"})
    EXPECT_EQ(word_of("Define: {array a[2];}\nStart: {x = 1; " + std::string(statement) +
                      "}\nAxiom: A(x)\nA --> A"),
              "A(1)")
        << statement;
  EXPECT_EQ(word_of("Start: {srand(1); -ran(1);}\nAxiom: A(ran(1))\nA --> A"), "A(0.45449245)");
  EXPECT_EQ(word_of("derivation length: 1\nAxiom: A(2)\nA(x) : {-x;} 1 {x; x = x + 1;} --> B(x)"), "B(3)");
  for (const char* wrong : {"-x = 3;", "(x) = 3;", "2 = x;", "sin(1) = 2;"})
    EXPECT_NE(word_of("Start: {" + std::string(wrong) + "}\nAxiom: A\nA --> A").find("expected a statement"),
              std::string::npos)
        << wrong;
}

TEST(CpfgChance, IsTheGeneratorOfTheCLibrary) {
  // drand48 after srand48(1) gives 0.0416303447718782, 0.454492444728629; X = 0x330E begins as srand48(0).
  EXPECT_EQ(word_of("Start: {srand(1);}\nAxiom: A(ran(1),ran(1))\nA --> A"), "A(0.041630346,0.45449245)");
  EXPECT_EQ(word_of("Axiom: A(ran(2))\nA --> A"), "A(0.34165606)");
  cpfg::FormulaChance chance;
  cpfg::seed_chance(chance, 1);
  EXPECT_NEAR(chance.stream.next(), 0.0416303447718782, 1e-15);
}

TEST(CpfgChance, NormalNumbersComeInPairs) {
  cpfg::FormulaChance chance;
  EXPECT_EQ(cpfg::normal_number(chance), 0);  // before any srand
  cpfg::seed_chance(chance, 5);
  cpfg::Congruential48 stream = chance.stream;
  double a = 0, b = 0, q = 0;
  do {
    a = 2 * stream.next() - 1;
    b = 2 * stream.next() - 1;
    q = a * a + b * b;
  } while (q >= 1);
  double g = std::sqrt(-2 * std::log(q) / q);
  EXPECT_EQ(cpfg::normal_number(chance), b * g);
  EXPECT_EQ(cpfg::normal_number(chance), a * g);
}

TEST(CpfgChance, BetaAndBinomialNumbersHaveTheirMeans) {
  cpfg::FormulaChance chance;
  cpfg::seed_chance(chance, 9);
  double beta = 0, binomial = 0;
  for (int i = 0; i < 20'000; ++i) {
    beta += cpfg::beta_number(chance, 2, 3) / 20'000;
    binomial += cpfg::binomial_number(chance, 10, 0.3) / 20'000;
  }
  EXPECT_NEAR(beta, 0.4, 0.01);
  EXPECT_NEAR(binomial, 3, 0.05);
}

TEST(CpfgChance, ProductionsDrawOneNumberAPlace) {
  // The first numbers of X = seed + 155 2^32: what each place draws decides between B (u <= 1/4) and C.
  cpfg::Congruential48 lots = cpfg::lots_of(3);
  std::string expected;
  for (int i = 0; i < 8; ++i) {
    double u = lots.next();
    expected += i % 2 == 1 ? "X" : u * 4 - 1 <= 0 ? "B" : "C";
  }
  EXPECT_EQ(word_of("Seed: 3\nderivation length: 1\nAxiom: AXAXAXAX\nA --> B : 1\nA --> C : 3"), expected);
  EXPECT_NE(expected.find('B'), std::string::npos) << "the seed makes only one kind";
  // Without a seed the weight has no effect.
  EXPECT_EQ(word_of("derivation length: 1\nAxiom: AA\nA --> B : 1\nA --> C : 1000"), "BB");
}

TEST(CpfgChance, VariationsAreOtherPlantsOfOneModel) {
  auto varied = [](const char* lines, std::uint64_t variation) {
    CpfgRequest request;
    request.variation = variation;
    return word_of(lines, request);
  };
  for (const char* lines : {"Axiom: A(ran(1))\nA --> A", "Axiom: A(nran(0,1))\nA --> A",
                            "Start: {srand(4);}\nAxiom: A(ran(1))\nA --> A",
                            "Seed: 3\nderivation length: 1\nAxiom: AAAAAAAAAAAAAAAA\nA --> B\nA --> C"}) {
    EXPECT_EQ(varied(lines, 0), word_of(lines));
    EXPECT_EQ(varied(lines, 77), varied(lines, 77)) << lines;
    EXPECT_NE(varied(lines, 77), varied(lines, 0)) << lines;
    EXPECT_NE(varied(lines, 77), varied(lines, 78)) << lines;
  }
}

}  // namespace
}  // namespace frond
