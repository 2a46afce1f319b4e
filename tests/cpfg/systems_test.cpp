#include "cpfg/model_folder.h"

namespace frond {
namespace {

/// A first L-system with a second.
std::string both(const std::string& first, const std::string& second, CpfgRequest request = {}) {
  return word_of(ModelFiles({{"m.l", grammar_of(first) + "Lsystem: 2\n" + second + "\nendlsystem\n"}}),
                 request);
}

TEST(CpfgSystems, APartIsRewrittenByItsOwn) {
  EXPECT_EQ(both("derivation length: 2\nAxiom: A\nA --> ?(2,0.5)A$B\nB --> C", "Axiom: Z\nA --> DA\nB --> E"),
            "?(2,0.5)DA$C");
  // Contexts see across.
  EXPECT_EQ(both("derivation length: 2\nAxiom: XA\nA --> ?(2,1)Y$W", "Axiom: Z\nX < Y > W --> #"),
            "X?(2,1)#$W");
}

TEST(CpfgSystems, EachPartHasItsVariables) {
  EXPECT_EQ(both("derivation length: 3\nAxiom: AB\nA --> ?(2,1)Y(0)$\nB --> C\nC --> ?(2,1)Y(0)$",
                 "Start: {n = 10;}\nStartEach: {n = n + 1;}\nAxiom: Z\nY(x) --> Y(n)"),
            "?(2,1)Y(12)$?(2,1)Y(11)$");
}

TEST(CpfgSystems, ExternalNamesAreThoseAround) {
  EXPECT_EQ(both("derivation length: 2\nDefine: { array a[2]={4,5}; }\nStart: {n = 3;}\nStartEach: {n = n + "
                 "1;}\nAxiom: A\nA --> ?(2,1)Y(0)$",
                 "Define: { external n, a[2]; }\nAxiom: Z\nY(x) : * {a[0] = 9;} --> Y(n,a[0],a[1])"),
            "?(2,1)Y(5,9,5)$");
}

TEST(CpfgSystems, APartInAPart) {
  EXPECT_EQ(both("derivation length: 3\nStart: {n = 3;}\nAxiom: A\nA --> ?(2,1)Y$",
                 "Define: { external n; }\nAxiom: Z\nY --> ?(3,1)W(0)$\nendlsystem\nLsystem: 3\nDefine: { "
                 "external n; }\n"
                 "Axiom: Z\nW(x) : * {n = n + 1;} --> W(n)"),
            "?(2,1)?(3,1)W(4)$$");
  // A part whose beginning a rule takes away goes on.
  EXPECT_EQ(both("derivation length: 3\nStart: {n = 3;}\nAxiom: A\nA --> X?(2,1)Y$\nX?(a,b) --> K\nY --> N",
                 "Define: { external n; }\nAxiom: Z\nY --> W(n)"),
            "KN$");
}

TEST(CpfgSystems, Mistakes) {
  EXPECT_NE(both("derivation length: 1\nAxiom: A\nA --> ?(3,1)$", "Axiom: A\nA --> A")
                .find("no L-system of that number"),
            std::string::npos);
  EXPECT_NE(both("derivation length: 9\nAxiom: A\nA --> ?(2,1)A$", "Axiom: A\nA --> ?(2,1)A$")
                .find("within itself"),
            std::string::npos);
}

TEST(CpfgSystems, TheScaleOfADrawing) {
  ModelFiles files({{"m.l", grammar_of("derivation length: 1\nAxiom: A\nA --> F?(2,0.5)FF$F") +
                                "Lsystem: 2\nAxiom: F\nq --> q\nendlsystem\n"}});
  CpfgRequest request;
  request.drawing = true;
  Result<CpfgModel> model = read_cpfg(files.path());
  ASSERT_TRUE(model.ok()) << model.errors()[0].text();
  Result<CpfgDerived> derived = derive(*model, request);
  ASSERT_TRUE(derived.ok());
  EXPECT_EQ(derived->drawing.scale, (std::vector<float>{1, 0.5, 0.5, 0.5, 1, 1}));
}

}  // namespace
}  // namespace frond
