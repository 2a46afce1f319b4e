#include <cstdlib>

#include "core/seed.h"
#include "cpfg/model_folder.h"

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

std::string mutant(Seed seed) {
  std::string text = kModels[seed.child("model").bits() % kModels.size()];
  for (std::uint64_t i = 0, n = 1 + seed.child("count").bits() % 3; i < n; ++i) {
    Seed place = seed.child("place", i);
    std::size_t at = place.bits() % (text.size() + 1), length = place.child("length").bits() % 8;
    switch (place.child("kind").bits() % 4) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, kPieces[place.child("piece").bits() % kPieces.size()]);
        break;
      case 2:
        text.insert(at, text.substr(place.child("from").bits() % text.size(), length * 4));
        break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(place.child("byte").bits());
    }
    if (text.empty()) text = " ";
  }
  return text;
}

TEST(CpfgFuzz, AnyTextIsDerivedOrRefused) {
  const char* count = std::getenv("FROND_FUZZ");  // for longer runs by hand
  ModelFiles files({{"m.v", "angle factor: 4\ntropism: T: 0,1,0 A: 20 I: 1 E: 0.1 S: 0.1\n"}});
  int right = 0;
  for (std::uint64_t i = 0, n = count ? std::stoull(count) : 3000; i < n; ++i) {
    Result<CpfgModel> model = read_cpfg(files.path(), mutant(Seed{i}));
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
