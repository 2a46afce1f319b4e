#include <chrono>

#include "cpfg/model_folder.h"
#include "cpfg/view.h"

// Models that cpfg reads though they look unusual, and such that would never end.

namespace frond {
namespace {

TEST(CpfgKinds, SystemsWithoutProductionsAreRead) {
  EXPECT_EQ(word_of("derivation length: 2\nAxiom: FA"), "FA");
  EXPECT_EQ(word_of("derivation length: 1\nAxiom: A\ndecomposition\nmaximum depth: 2\nA --> FA"), "FFA");
  ModelFiles drawn({{"m.l", grammar_of("Axiom: A\nhomomorphism\nA --> F(2)")}});
  EXPECT_EQ(drawing_of(drawn), "F(2)");
}

TEST(CpfgKinds, FormulasMayBeginWithSeveralSigns) {
  const std::string head = "derivation length: 1\nAxiom: A(1)\n";
  EXPECT_EQ(word_of(head + "A(x) : -x < 5 --> F(-x)"), "F(-1)");
  EXPECT_EQ(word_of(head + "A(x) : !-x --> F\nA(x) : --x --> G(- -x)"), "G(1)");
  EXPECT_EQ(word_of(head + "A(x) : -!x + 1 --> F(!-(x-1), !&x)"), "F(1,0)");
  EXPECT_EQ(word_of(head + "A(x) : * --> B(x)\ndecomposition\nmaximum depth: -1\nB(x) --> C"), "B(1)");
}

TEST(CpfgKinds, CallsMayBeSpreadOverTabsAndLines) {
  const std::string macro = "#define L(a,b) F(a)[+(b)]\nLsystem: 1\nderivation length: 1\nAxiom: A\n";
  for (const char* call :
       {"A --> L(1,2)", "A --> L\n\t(1,\n\t2)", "A --> L\t\n\n\t\t(\t1\n,\n\t2\t)", "A --> L\n(1,2)"}) {
    ModelFiles files({{"m.l", macro + call + "\nendlsystem\n"}});
    EXPECT_EQ(word_of(files), "F(1)[+(2)]") << call;
  }
  EXPECT_EQ(word_of("derivation length: 1\nAxiom: A\nA --> F\n\t(\n\tsin(\n\t\t30\n\t)\n\t)"), "F(0.5)");
  // A name without arguments stays, also at the end of all.
  ModelFiles bare({{"m.l", macro + "A --> L\nB --> C\nendlsystem\n"}});
  EXPECT_EQ(word_of(bare), "L");
}

TEST(CpfgKinds, ASectionMayBeginInTheLineOfItsName) {
  ModelFiles drawn({{"m.l", grammar_of("Axiom: A^(30)\nA --> B\nhomomorphism: ^(a) --> +(a)\nA --> F")}});
  EXPECT_EQ(drawing_of(drawn), "F+(30)");
  ModelFiles warned({{"m.l", grammar_of("Axiom: A-(30)\nA --> B\nHomomorphism no warnings -(a) --> +(a)")}});
  EXPECT_EQ(drawing_of(warned), "A+(30)");
  EXPECT_EQ(word_of("derivation length: 1\nAxiom: A\nA --> B\ndecomposition: B --> C"), "C");
  EXPECT_EQ(word_of("derivation length: 1\nAxiom: A\nA --> B\ndecomposition : warnings\nB --> C"), "C");
}

/// How many seconds it takes, and what is said.
template <class Work>
double seconds(const Work& work) {
  auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST(CpfgKinds, IncludeBombsEndInSeconds) {
  ModelFiles files({{"m.l", "#include \"a0.h\"\n"}});
  for (int i = 0; i < 18; ++i) {
    std::string text;
    for (int k = 0; k < 10; ++k) text += "#include \"a" + std::to_string(i + 1) + ".h\"\n";
    files.write("a" + std::to_string(i) + ".h", text);
  }
  files.write("a18.h", "");
  std::string said;
  EXPECT_LT(seconds([&] { said = word_of(files); }), 20);
  EXPECT_NE(said.find("more than 2,000 files"), std::string::npos) << said;
}

TEST(CpfgKinds, LoopsWithoutEndEndInSecondsWithTheirLine) {
  for (const char* loop :
       {"while (1) {x = 1;}", "do {x = 1;} while (1);", "while (1) {while (1) {x = x + 1;}}",
        "y = 1; while (y) {x = 0; while (x < 3) {x = x + 1;}}"}) {
    ModelFiles files(
        {{"m.l", grammar_of(std::string("derivation length: 1\nAxiom: A\nA : {\n") + loop + "\n} 1 --> A")}});
    Result<CpfgModel> model = read_cpfg(files.path());
    ASSERT_TRUE(model.ok());
    Error error;
    EXPECT_LT(seconds([&] { error = derive(*model, {}).errors()[0]; }), 20) << loop;
    EXPECT_NE(error.where.find("line 5"), std::string::npos) << error.text();
    EXPECT_NE(error.what.find("may go on without end"), std::string::npos) << error.text();
  }
  // Loops that end are carried out, however often they come.
  EXPECT_EQ(word_of("derivation length: 3\nAxiom: A\nA : {x = 0; while (x < 1000) {x = x + 1;}} 1 --> AF(x)"),
            "AF(1000)F(1000)F(1000)");
}

TEST(CpfgKinds, EmptyFilesAreNamed) {
  for (const char* text : {"", "\n", "\x1a", "#define X 1\n"}) {
    ModelFiles files({{"m.l", text}});
    Result<CpfgModel> model = read_cpfg(files.path());
    ASSERT_FALSE(model.ok());
    EXPECT_NE(model.errors()[0].where.find("m.l"), std::string::npos) << model.errors()[0].text();
  }
}

TEST(CpfgKinds, FilesOfOtherSystemsAreReadAlike) {
  const std::string plain = grammar_of("derivation length: 1\nAxiom: A\nA --> F\n\t[+A]");
  std::string dos;
  for (char c : plain) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  for (const std::string& text :
       {plain, dos, "\xef\xbb\xbf" + plain, dos + "\x1a", plain + "\x1a" + "left over"}) {
    ModelFiles files({{"m.l", text}});
    EXPECT_EQ(word_of(files), "F[+A]");
  }
}

TEST(CpfgKinds, SignsThatOnlyLookLikeOthersAreNamed) {
  ModelFiles files({{"m.l", grammar_of("Axiom: A /* \u2212 */\nA --> F\u2212(30)A")}});
  Result<CpfgModel> model = read_cpfg(files.path());
  ASSERT_FALSE(model.ok());
  EXPECT_NE(model.errors()[0].text().find("line 3: column 8: `\u2212` (U+2212) is not `-`"),
            std::string::npos)
      << model.errors()[0].text();
}

TEST(CpfgKinds, NumbersOfAViewDoNotFollowTheLocale) {
  EXPECT_EQ(cpfg::leading_number("1.5x"), 1.5);
  EXPECT_EQ(cpfg::leading_number("+2"), 2);
  EXPECT_EQ(cpfg::leading_number("x"), 0);
  EXPECT_EQ(cpfg::leading_whole("-3.9"), -3);
}

TEST(CpfgKinds, ModelsOfLPyAreKnownByWhatIsInThem) {
  for (const char* text :
       {"module A\nAxiom: A\nderivation length: 2\nproduction:\nA :\n  produce A\n",
        "from random import randint\nAxiom: A\n", "Axiom: A\ninterpretation:\nA --> F\n"}) {
    ModelFiles files({{"m.l", text}});
    Result<CpfgModel> model = read_cpfg(files.path());
    ASSERT_FALSE(model.ok());
    EXPECT_NE(model.errors()[0].what.find("L-Py"), std::string::npos) << text;
  }
  ModelFiles files({{"m.l", "#include <lpfgall.h>\nmodule A(float);\nderivation length: 3;\n"}});
  EXPECT_NE(word_of(files).find("lpfg (L+C)"), std::string::npos);
}

}  // namespace
}  // namespace frond
