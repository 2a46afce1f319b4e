#include "cpfg/preprocess.h"

#include "cpfg/model_folder.h"

namespace frond {
namespace {

/// What is left of a text, without blanks at its lines' ends and empty lines.
std::string plain(const std::string& text) {
  auto include = [](const std::string& name) -> Result<std::string> {
    if (name == "part.h") return std::string("#define PART 5\nincluded\n");
    if (name == "loop.h") return std::string("#include \"loop.h\"\n");
    return Error{"", "there is no such file"};
  };
  Result<cpfg::PlainText> read = cpfg::preprocess("m.l", text, {{"LEAF", "2"}}, include);
  if (!read) return read.errors()[0].text();
  std::string out;
  for (char c : read->text)
    if (c != ' ' && !(c == '\n' && (out.empty() || out.back() == '\n'))) out += c;
  return out;
}

TEST(CpfgPreprocess, Macros) {
  EXPECT_EQ(plain("#define N 1+1\n2*N\n"), "2*1+1\n");
  EXPECT_EQ(plain("#define X F\nXN(1) X N X_ 2X X(1)\n"), "XN(1)FNX_2XF(1)\n");
  EXPECT_EQ(plain("#define S(a,b) a+b\nS(1,S(2,(3,4))) S\n"), "1+2+(3,4)S\n");
  EXPECT_EQ(plain("#define L A \\\n  B \\\n  C\nL\n"), "ABC\n");
  EXPECT_EQ(plain("#define A B\n#define B A\nA B\n"), "AB\n");
  EXPECT_EQ(plain("#define A 1\n#undef A\nA\n"), "A\n");
  EXPECT_EQ(plain("LEAF \"LEAF\"\n"), "2\"LEAF\"\n");
  EXPECT_EQ(plain("#define W(x) [x]#(x)\n  W(F G)\n"), "[FG]#(FG)\n");
  EXPECT_EQ(plain("#define S(a) a\nS(1\n,2)\n"), "m.l: line 2: the macro `S` has 2 arguments; expected 1");
  EXPECT_EQ(plain("#define S(a,b) a##b\nS(1\n,2)\n"), "12\n");
}

TEST(CpfgPreprocess, CommentsAndLines) {
  EXPECT_EQ(plain("A/* x\n y */B\nF//G\nH\n"), "AB\nF\nH\n");
  EXPECT_EQ(plain("A\\\nB\n\"//\"\n"), "AB\n\"//\"\n");
  EXPECT_EQ(plain("\t#(0.1)F\n"), "\t#(0.1)F\n");  // no directive
}

TEST(CpfgPreprocess, Conditions) {
  EXPECT_EQ(plain("#if 1 > 2\nA\n#elif defined(LEAF) && LEAF == 2\nB\n#else\nC\n#endif\n"), "B\n");
  EXPECT_EQ(plain("#ifdef NONE\n#if 1\nA\n#endif\n#else\nB\n#endif\n"), "B\n");
  EXPECT_EQ(plain("#ifndef NONE\nA\n#endif\n#if NONE\nB\n#endif\n"), "A\n");
  EXPECT_EQ(plain("#if 1\nA\n"), "m.l: line 2: an #if has no #endif");
  EXPECT_EQ(plain("#endif\n"), "m.l: line 1: #endif without an #if");
}

TEST(CpfgPreprocess, IncludedFiles) {
  EXPECT_EQ(plain("#include \"part.h\"\nPART\n"), "included\n5\n");
  EXPECT_EQ(plain("\n#include \"none.h\"\n"), "m.l: line 2: #include \"none.h\": there is no such file");
  EXPECT_NE(plain("#include \"loop.h\"\n").find("20 deep"), std::string::npos);
  ModelFiles files({{"m.l", "#include \"../part.h\"\n"}});
  EXPECT_NE(word_of(files).find("not below the model's folder"), std::string::npos);
}

TEST(CpfgPreprocess, TextsThatExplodeAreRefused) {
  std::string text = "#define A0 xxxxxxxxxx\n";
  for (int i = 1; i < 9; ++i) {
    std::string before = "A" + std::to_string(i - 1), line = "#define A" + std::to_string(i);
    for (int k = 0; k < 10; ++k) line += " " + before;
    text += line + "\n";
  }
  EXPECT_NE(plain(text + "A8\n").find("too long"), std::string::npos);
}

TEST(CpfgConstant, IsAsInC) {
  for (auto [text, value] : std::vector<std::pair<std::string, long long>>{{"1+2*3", 7},
                                                                           {"(1+2)*3", 9},
                                                                           {"10-2-3", 5},
                                                                           {"!0 && -1", 1},
                                                                           {"7/2%2", 1},
                                                                           {"1 || x", 1},
                                                                           {"3>=3 == 1", 1},
                                                                           {"1/0", 0}})
    EXPECT_EQ(cpfg::constant_value(text), value) << text;
  for (std::string text : {"", "1+", "(1", "1 2", "a.b"}) EXPECT_FALSE(cpfg::constant_value(text)) << text;
}

TEST(CpfgPreprocess, MacrosMakeWholeModels) {
  EXPECT_EQ(word_of("#define STEPS 2\n#define RULE(a,b) a --> b\n#define START A(STEPS)B\nderivation length: "
                    "STEPS\nAxiom: START\nRULE(B,C)\n"
                    "#if 0\nA(x) --> D\n#endif\nRULE(C,DD)"),
            "A(2)DD");
}

}  // namespace
}  // namespace frond
