#include "cpfg/model_folder.h"

namespace frond {
namespace {

/// What is said of a file, with its place.
std::string said(const std::string& text, const std::string& name = "m.l") {
  ModelFiles files({{name.c_str(), text}});
  Result<CpfgModel> model = read_cpfg(files.path(name));
  if (model) return "";
  std::string where = model.errors()[0].where;
  return where.substr(where.rfind('/') + 1) + ": " + model.errors()[0].what;
}

TEST(CpfgRead, OtherLanguagesAreNamed) {
  EXPECT_NE(said("#include <lpfgall.h>\nmodule A(float);\n").find("lpfg (L+C)"), std::string::npos);
  EXPECT_NE(said("from openalea.plantgl.all import *\nAxiom: A\n").find("L-Py"), std::string::npos);
  EXPECT_NE(said("Axiom: A\nproduction:\nA :\n  produce B\n", "m.lpy").find("L-Py"), std::string::npos);
  EXPECT_NE(said(grammar_of("Axiom: A\nA --> ?E(0)A")).find("asks a program for the environment"),
            std::string::npos);
}

TEST(CpfgRead, MistakesHaveTheirLine) {
  for (auto [lines, message] : std::vector<std::pair<std::string, std::string>>{
           {"Axiom: A\nA -> B", "line 3: `->` is no arrow of cpfg; expected `-->`"},
           {"Axiom: A\nA -->", "line 3: there is no word; the empty one is written `*`"},
           {"Axiom: A\nA\n--> B",
            "line 3: found the end of the line: expected `-->`; a line that goes on begins with a tab"},
           {"Axiom: A\nA : --> B", "line 3: there is no condition before the arrow; expected one, or `*`"},
           {"Axiom: A\nA(x) : x = 1 --> B", "line 3: `=` assigns; a comparison is written `==`"},
           {"Axiom: A\nA(1) --> B", "line 3: found `1) --> B`: expected the name of a parameter"},
           {"Axiom: A\nhomomorphism\nA --> F\ndecomposition\nA --> B",
            "line 5: the decomposition comes after the homomorphism"},
           {"A --> B", "the L-system has no `Axiom:`"},
           {"Axiom: A\nproduction:\nA --> B", "L-Py"},
           {"Axiom: A\nA --> B\nring L-system: 1", "expected `-->`"},
           {"Axiom: A*B\nA --> B", "line 2: found `*B`: expected a module"},
           {"Axiom: A\nA : {x = 1} * --> B", "line 3: found `} * --> B`: expected `;`"},
           {"Start: {x = ;}\nAxiom: A\nA --> A", "line 2: found `;}`: expected a number, a name or `(`"},
           {"Define: { array a[0]; }\nAxiom: A\nA --> A", "size of 1 or more"}})
    EXPECT_NE(said(grammar_of(lines)).find(message), std::string::npos) << lines << "\n"
                                                                        << said(grammar_of(lines));
  EXPECT_NE(said("Axiom: A\nA --> B\n").find("expected `Lsystem: 1`"), std::string::npos);
  EXPECT_NE(said("Lsystem: 1\nAxiom: A\nA --> B\n").find("no `endlsystem`"), std::string::npos);
  EXPECT_EQ(said("lsystem: x\nAxiom: A\nA --> B\nEndLsystem\n"), "");
}

TEST(CpfgRead, DeepFormulasAreRefused) {
  std::string deep(5000, '('), minus(5000, '-'), sum = "1";
  for (int i = 0; i < 20'000; ++i) sum += "+1";
  for (const std::string& formula : {deep, minus + "1", sum})
    EXPECT_NE(said(grammar_of("Axiom: A(" + formula + ")\nA --> A")).find("formula"), std::string::npos);
}

}  // namespace
}  // namespace frond
