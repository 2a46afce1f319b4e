#include <cstdlib>

#include "cpfg/model_folder.h"
#include "mutant.h"

namespace frond {
namespace {

/// Grammars that use everything.
const std::vector<std::string> kModels{
    "#define N 3\n#define TURN(a) [+(a)B(a)]\nLsystem: 1\nSeed: 4\nderivation length: N\nignore: +-\nDefine: "
    "{ array a[3]={1,2,3}; }\n"
    "Start: {srand(3); n = 0;}\nStartEach: {n = n + a[1];}\nAxiom: A(1)F\nA(x) : {y = ran(2);} x < 9 && y > "
    "0.1 {n = n + 1;} -->\n\tF(n)TURN(30)%A(x*2) : 2\n"
    "A(x) --> B(nran(1,2)) : 1\nF(l) < B(x) > F : * --> *\ndecomposition\nmaximum depth: 5\nB(x) : x > 1 --> "
    "B(x/2)C\nhomomorphism\nseed: 3\n"
    "C --> ;(3)F(1)@Gc(2)\nendlsystem\n",
    "Lsystem: 1\nring lsystem\nderivation length: 4\nconsider: AB[]\nAxiom: A[B]A?P(0,0,0)\nA < B > A --> "
    "[=A]\nA > [=]A : 1 ? 2 : 3 --> BA\n"
    "?P(x,y,z) : x^2+y*z/0 >= 0 --> ?P(z,y,x)F\nB --> A!(2)&/\\@R(1,2,3)@D(2)\nendlsystem\n",
    "#ifdef X\n#else\n#if 1 > 0 && !defined(Y)\n#define B(x,y) x/*c*/y // d\n#endif\n#endif\nLsystem: "
    "1\nderivation length: 3\nStart: {n=1; while (n < 9) "
    "{n = n * 2; if (n == 4) {n = 5;} else {do {n = n + 1;} while (n < 3);}}}\nAxiom: AB(C,D)\nA --> "
    "?(2,0.5)Y(n)$A\nC --> @L(\"x %f\",n)\nendlsystem\n"
    "Lsystem: 2\nDefine: { external n, b[2]; }\nAxiom: Y\nY(x) : * {n = n + x; b[x] = 2;} --> "
    "Y(b[1]%2)[Y(-x)]\nendlsystem\n"};
const std::vector<std::string> kPieces{
    "\n", "\n\t", "(",       ")",           "[",        "]",    "{",          "}", "-->", ":",
    "<",  ">",    "=",       "*",           ",",        ";",    "%",          "?", "$",   "#",
    "\"", "\\\n", "/*",      "A",           "x",        "1",    "9999999999", "-", "^",   "!",
    "&&", "ran(", "func(1,", "while (1) {", "#define ", "#if ", "array ",     "."};

std::string mutant_of_a_model(Seed seed) {
  return mutant(kModels[seed.child("model").bits() % kModels.size()], kPieces, seed);
}

TEST(CpfgFuzz, AnyTextIsDerivedOrRefused) {
  const char* count = std::getenv("FROND_FUZZ");  // for longer runs by hand
  ModelFiles files({{"m.v", "angle factor: 4\ntropism: T: 0,1,0 A: 20 I: 1 E: 0.1 S: 0.1\n"}});
  int right = 0;
  for (std::uint64_t i = 0, n = count ? std::stoull(count) : 3000; i < n; ++i) {
    Result<CpfgModel> model = read_cpfg(files.path(), mutant_of_a_model(Seed{i}));
    if (!model) {
      ASSERT_FALSE(model.errors()[0].what.empty());
      continue;
    }
    CpfgRequest request;
    request.drawing = true;
    request.limits = {20, 2000, 50'000};
    Result<CpfgDerived> derived = derive(*model, request);
    if (!derived) continue;
    ++right;
    ASSERT_LE(derived->word.modules.size(), request.limits.modules + 1000);
    ASSERT_EQ(derived->drawing.scale.size(), derived->drawing.word.modules.size());
    EXPECT_FALSE(text(derived->word, *model).empty() && !derived->word.modules.empty());
  }
  EXPECT_GT(right, count ? 0 : 200);
}

/// The files of a model that uses them all.
const std::vector<std::pair<const char*, std::string>> kFiles{
    {"m.l",
     "Lsystem: 1\nderivation length: 1\nAxiom: @#(1)@Gs(3)f(1)@Gc(3)f(2)@Ge(3)~a(2)[;(3)~b]F(func(1,0.5))\n"
     "F --> F\nendlsystem\n"},
    {"m.v",
     "angle increment: 30\ninitial color: 1 2\ninitial line width: 0.2 cylinders\nsurface: a one.s 0.5\n"
     "tsurface: b two.tri 1\ncontour: 1 c.con\nfunction: f.func\ntropism: T: 0,1,0 A: 20 I: 1 E: 0.1 S: 0.1\n"
     "viewpoint: 0,3,10\n"},
    {"m.a", "first frame: 0\nlast frame: 4\nstep: 1\n"},
    {"m.map", std::string(768, 'x')},
    {"one.s",
     "-1 1 0 1 -1 1\nPRECISION S: 4 T: 4\nCONTACT POINT X: 0 Y: 0 Z: 0\nEND POINT X: 0 Y: 1 Z: 0\n"
     "HEADING X: 0 Y: 1 Z: 0\nUP X: 0 Y: 0 Z: 1\nSIZE: 1\none\nTOP COLOR: 1 DIFFUSE: 0\n"
     "BOTTOM COLOR: 2 DIFFUSE: 0\nAL: ~ A: ~ AR: ~\nL: ~ R: ~\nBL: ~ B: ~ BR: ~\n"
     "0 0 0 0 0 0 0 0 0 0 0 0\n-0.3 0.3 0 -0.1 0.3 0 0.1 0.3 0 0.3 0.3 0\n"
     "-0.3 0.7 0 -0.1 0.7 0 0.1 0.7 0 0.3 0.7 0\n0 1 0 0 1 0 0 1 0 0 1 0\n"},
    {"two.tri", "triangle\n0 0 0\n1 0 0\n0 1 0\ntriangle\n0 0 0\n0 1 0\n0 0 1\n"},
    {"c.con", "cver 1 1\nname: c\npoints: 4 4\ntype: oe\nsamples: 6\n1 0 0 1\n0 1 0 1\n-1 0 0 1\n0 -1 0 1\n"},
    {"f.func", "range: 0 1\npoints: 4\n0 0\n0.25 0.25\n0.75 0.75\n1 1\n"}};

TEST(CpfgFuzz, AnyFileOfAModelIsDrawnOrRefused) {
  const char* count = std::getenv("FROND_FUZZ");
  ModelFiles files({});
  for (const auto& [name, text] : kFiles) files.write(name, text);
  int right = 0;
  for (std::uint64_t i = 0, n = count ? std::stoull(count) : 600; i < n; ++i) {
    Seed seed{i};
    const auto& [name, text] = kFiles[1 + seed.child("file").bits() % (kFiles.size() - 1)];
    files.write(name, mutant(text, kPieces, seed));
    Result<CpfgModel> model = read_cpfg(files.path());
    files.write(name, text);
    if (!model) {
      ASSERT_FALSE(model.errors()[0].what.empty());
      continue;
    }
    CpfgRequest request;
    request.drawing = true;
    request.limits = {20, 2000, 50'000};
    Result<CpfgDerived> derived = derive(*model, request);
    Result<CpfgFigure> figure =
        derived ? draw(*model, derived->drawing) : Result<CpfgFigure>(derived.errors());
    if (figure)
      ++right;
    else
      ASSERT_FALSE(figure.errors()[0].what.empty());
  }
  EXPECT_GT(right, count ? 0 : 200);
}

TEST(CpfgFuzz, TheModelsAreRight) {
  ModelFiles files({});
  for (const std::string& text : kModels) {
    Result<CpfgModel> model = read_cpfg(files.path(), text);
    ASSERT_TRUE(model.ok()) << model.errors()[0].text();
    Result<CpfgDerived> derived = derive(*model, {});
    EXPECT_TRUE(derived.ok()) << derived.errors()[0].text();
  }
}

}  // namespace
}  // namespace frond
