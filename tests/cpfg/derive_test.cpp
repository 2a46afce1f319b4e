#include "cpfg/model_folder.h"

namespace frond {
namespace {

struct WordCase {
  const char* lines;
  const char* word;
};

void expect_words(const std::vector<WordCase>& cases) {
  for (const WordCase& known : cases) EXPECT_EQ(word_of(known.lines), known.word) << known.lines;
}

TEST(CpfgDerive, LinesGoOnAfterATab) {
  expect_words({
      {"derivation length: 1\nAxiom: A\n\tB\nA\n\t--> C\n\tD\nB --> E", "CDE"},
      {"derivation length: 1\nAxiom: A(1,\n\t2)\nA(x,\n\ty) : x <\n\ty\n\t--> B(x +\n\ty)", "B(3)"},
      {"Derivation Length: 1\nAxiom:A\n  A --> B (1)  C", "B(1)C"},
      {"derivation length: 1\nAxiom: A\nA : * {\nx = 1;\n\n y = 2; } --> B(x,y)", "B(1,2)"},
      {"derivation length: 1\nAxiom: A\nA : { x = 3; }\n\tx > 2 {\ny = 4;\n} --> B(x,y)", "B(3,4)"},
  });
}

TEST(CpfgDerive, TheFormOfTheFile) {
  expect_words({
      {"Axiom: AB\nA --> B", "AB"},  // no derivation length: 0
      {"derivationlength: 1.9\nAxiom: A\nA --> B", "B"},
      {"derivation length: 2*2-1\nAxiom: A(0)\nA(x) --> A(x+1)", "A(3)"},
      {"derivation length: 1\nAxiom: A\nA --> *", ""},
      {"derivation length: 1\nAxiom: A\nA --> B\nA --> C", "B"},
      {"derivation length: 3\nAxiom: A(Z,Q)\nA(x,y) --> A(Z,Q)", "A(3,3)"},
      {"derivation length: 1\nAxiom: A\nB : 0 --> C\nA --> B", "B"},
      {"derivation length: 1\nAxiom: A\nA -o> B", "B"},
  });
}

TEST(CpfgDerive, ModulesAreSingleCharacters) {
  expect_words({
      {"derivation length: 1\nAxiom: @Gc(4)~l(2)1=.,;~@?$\"\nc(n) --> c(n+1)\nl(x) --> k(x)",
       "@Gc(5)~k(2)1=.,;~@?$\""},
      {"derivation length: 1\nAxiom: A(1)AA(1,2)\nA(x) --> B\nA --> C", "BCA(1,2)"},
      {"derivation length: 1\nAxiom: A]B\nA --> [CD\nB --> ]", "[CD]]"},
      {"derivation length: 1\nAxiom: A(1)\nA(x) : x-->B", "B"},
  });
  EXPECT_NE(word_of("Axiom: A()\nA --> B").find("expected 1 to 255"), std::string::npos);
}

TEST(CpfgDerive, ParametersHave32Bits) {
  // 0.1 in 32 bits is above the double 0.1.
  expect_words({
      {"derivation length: 1\nAxiom: A(0.1)\nA(x) : x > 0.1 --> B(x)", "B(0.1)"},
      {"derivation length: 1\nAxiom: A(16777216)\nA(x) --> A(x+1)", "A(16777216)"},
      {"derivation length: 1\nAxiom: A(1/3)\nA(x) --> A(x)", "A(0.33333334)"},
      {"derivation length: 1\nAxiom: A\nA : * {y = 16777217;} --> A(y-16777216)", "A(1)"},
  });
}

TEST(CpfgDerive, PredecessorsOfSeveralModules) {
  expect_words({
      {"derivation length: 1\nAxiom: A(2)BAB(1)\nA(n)B --> C(n)\nA --> D", "C(2)DB(1)"},
      {"derivation length: 1\nAxiom: AXB\nignore: X\nAB --> C", "AXB"},
      {"derivation length: 1\nAxiom: AA\nAA --> B\nA --> C", "B"},
      {"derivation length: 1\nAxiom: [A]A\n[A] --> B", "BA"},
  });
}

TEST(CpfgDerive, Blocks) {
  expect_words({
      // The block before runs although the condition fails; the one after only when the rule is used.
      {"derivation length: 1\nStart: {n = 0;}\nAxiom: AAB\nA : {n = n + 1;} n > 1 {n = n + 10;} --> C(n)\nB "
       "--> D(n)",
       "AC(12)D(12)"},
      {"derivation length: 1\nAxiom: A(3)\nA(x) : * {s=0; while (x > 0) {s = s + x; x = x - 1;}} --> B(s)",
       "B(6)"},
      {"derivation length: 1\nAxiom: A\nA : * {s=0; do {s = s + 1;} while (s < 5);} --> B(s)", "B(5)"},
      {"derivation length: 1\nAxiom: A(1)A(2)\nA(x) : * {if (x == 1) {y = 5;} else {y = 6;}} --> B(y)",
       "B(5)B(6)"},
  });
}

TEST(CpfgDerive, VariablesLiveOn) {
  expect_words({
      // x is the production's own and keeps its value.
      {"derivation length: 1\nAxiom: AAB\nA : {x = x + 1;} * --> C(x)\nB --> D(x)", "C(1)C(2)D(0)"},
      {"derivation length: 2\nStart: {x = 5;}\nAxiom: A(x)\nA(y) : * {x = x + y;} --> A(x)", "A(20)"},
      {"derivation length: 1\nStart: {x = 5;}\nAxiom: A(1)\nA(x) --> A(x)", "A(1)"},  // a parameter hides it
      {"derivation length: 2\nStart: {a = 0;}\nStart Each: {a = a + Q;}\nAxiom: A\nA --> A(a)\nA(x) --> "
       "A(x,a)",
       "A(1,3)"},
      {"derivation length: 2\nStart: {a = 1; b = 1;}\nEndEach: {a = a * 2;}\nEnd: {b = b + 1;}\nAxiom: A\nA "
       "--> A(a)\nA(x) --> A(x,a,b)",
       "A(1,2,1)"},
  });
}

TEST(CpfgDerive, Arrays) {
  expect_words({
      {"derivation length: 1\nDefine: { array a[3]={1,2,3}, b[2][2]={{1,2},{3,4}}; }\nAxiom: A\nA --> "
       "B(a[0],a[2],a[7],a[-1],b[1][0])",
       "B(1,3,3,1,3)"},
      {"derivation length: 1\nDefine: { array a[2]; }\nStart: { a[1] = 7; }\nAxiom: A\nA --> B(a[0],a[1])",
       "B(0,7)"},
  });
}

TEST(CpfgDerive, Decomposition) {
  const char* kHead = "derivation length: 1\nAxiom: A\nA --> X(9)\ndecomposition\n";
  EXPECT_EQ(word_of(std::string(kHead) + "X(n) : n > 1 --> X(n-1)B"), "X(8)B");
  EXPECT_EQ(word_of(std::string(kHead) + "maximum depth: 3\nX(n) : n > 1 --> X(n-1)B"), "X(6)BBB");
  EXPECT_EQ(word_of(std::string(kHead) + "maximum depth: 3000\nX(n) : n > 1 --> X(n-1)B"), "X(1)BBBBBBBB");
  // Modules without a rule are taken apart, too; the axiom is not.
  EXPECT_EQ(word_of("derivation length: 0\nAxiom: AX\nA --> A\ndecomposition\nX --> Y"), "AX");
  EXPECT_EQ(word_of("derivation length: 1\nAxiom: AX\nA --> A\ndecomposition\nX --> YY"), "AYY");
  // Contexts are those of the old word.
  EXPECT_EQ(word_of("derivation length: 1\nAxiom: LAR\nA --> XY\ndecomposition\nL < Y > R --> Z"), "LXZR");
  EXPECT_EQ(word_of("derivation length: 1\nAxiom: A\nA --> XYX\ndecomposition\nXY --> Z"), "ZX");
}

TEST(CpfgDerive, Homomorphism) {
  const char* kHead = "derivation length: 1\nAxiom: A(1)\nA(x) --> A(x+1)[B]\nhomomorphism\n";
  auto drawn = [&](const std::string& rules) {
    return drawing_of(ModelFiles({{"m.l", grammar_of(kHead + rules)}}));
  };
  EXPECT_EQ(drawn("A(x) --> F(x)A(x)"), "F(2)A(2)[B]");
  EXPECT_EQ(drawn("Maximum Depth: 2\nA(x) : x > 0 --> F(x)A(x-1)\nB --> C\nC --> D"), "F(2)F(1)A(0)[D]");
  EXPECT_EQ(word_of(std::string(kHead) + "A(x) --> F(x)"), "A(2)[B]");
}

TEST(CpfgDerive, Cut) {
  expect_words({
      {"derivation length: 1\nAxiom: A[B%A[A]A]A\nA --> C", "C[B]C"},
      {"derivation length: 1\nAxiom: A%AA\nA --> C", "C"},
      {"derivation length: 1\nAxiom: A%A\nA --> C\n% --> %", "C%C"},
      {"derivation length: 2\nAxiom: A%A\nA --> C\n% --> *", "CC"},
      {"derivation length: 1\nAxiom: A%A[A%(1,2)A]A\nA --> C", "C%(1,2)C]C"},
      {"derivation length: 1\nAxiom: A%A\nA --> C\ndecomposition\n% --> D", "CDC"},
  });
}

TEST(CpfgDerive, ModelsThatGoOnAreStopped) {
  CpfgRequest small;
  small.limits.modules = 1000;
  small.limits.work = 100'000;
  small.limits.steps = 500;
  EXPECT_EQ(word_of("derivation length: 50\nAxiom: A\nA --> AA", small),
            "step 10: the word has more than 1000 modules and parameters");
  EXPECT_NE(word_of("derivation length: 1\nStart: {while (1) {x = 1;}}\nAxiom: A\nA --> A", small)
                .find("without end"),
            std::string::npos);
  EXPECT_NE(word_of("derivation length: 1e0\nAxiom: A\nA --> A", small).find("expected the end"),
            std::string::npos);
  EXPECT_NE(word_of("derivation length: 501\nAxiom: A\nA --> A", small).find("expected at most 500"),
            std::string::npos);
  EXPECT_NE(
      word_of("derivation length: 1\nAxiom: A\nA --> A\ndecomposition\nmaximum depth: 1000000\nA --> AA",
              small)
          .find("more than"),
      std::string::npos);
}

TEST(CpfgDerive, TheModelMayStopItself) {
  expect_words({
      {"derivation length: 9\nAxiom: A(0)\nA(x) : * {if (x == 2) {stop(0);}} --> A(x+1)", "A(3)"},
      {"derivation length: 2\nAxiom: A(0)\nA(x) : * {if (x == 0) {SetDerivationLength(5);}} --> A(x+1)",
       "A(5)"},
  });
  CpfgRequest asked;
  asked.steps = 4;
  EXPECT_EQ(word_of("derivation length: 2\nAxiom: A(0)\nA(x) --> A(x+1)", asked), "A(4)");
}

}  // namespace
}  // namespace frond
