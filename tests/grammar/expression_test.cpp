#include "grammar/expression.h"

#include <gtest/gtest.h>

#include "grammar/derive.h"

namespace frond {
namespace {

std::string value(const std::string& formula) {
  GrammarText text;
  text.axiom = "A(3,-2)";
  text.rules = {{"A(x,y) -> V(" + formula + ")"}};
  Result<Grammar> grammar = compile(text);
  if (!grammar) return grammar.errors()[0].what;
  Result<Word> word = derive(*grammar, 1, Seed{1});
  return word ? frond::text(*grammar, *word) : word.errors()[0].text();
}

TEST(Expression, FollowsTheUsualOrder) {
  const std::pair<const char*, const char*> cases[] = {{"x+2*y", "V(-1)"},
                                                       {"(x+2)*y", "V(-10)"},
                                                       {"-x^2", "V(-9)"},
                                                       {"2^3^2", "V(512)"},
                                                       {"x%2", "V(1)"},
                                                       {"7-2-1", "V(4)"},
                                                       {"x>2 && y<0", "V(1)"},
                                                       {"x>2 and not y<0", "V(0)"},
                                                       {"x=3", "V(1)"},
                                                       {"x==3||1/0>2", "division"},
                                                       {"x!=3", "V(0)"},
                                                       {"min(x,y,-7)", "V(-7)"},
                                                       {"max(x,y)", "V(3)"},
                                                       {"floor(-1.5)", "V(-2)"},
                                                       {"ceil(x/2)", "V(2)"},
                                                       {"abs(y)", "V(2)"},
                                                       {"sign(y)", "V(-1)"},
                                                       {"sqrt(x+1)", "V(2)"},
                                                       {"exp(0)", "V(1)"},
                                                       {"log(1)", "V(0)"},
                                                       {"sin(30)", "V(0.5)"},
                                                       {"cos(60)", "V(0.5)"},
                                                       {"tan(45)", "V(1)"},
                                                       {"asin(1)", "V(90)"},
                                                       {"acos(0)", "V(90)"},
                                                       {"atan(1)", "V(45)"},
                                                       {"atan2(1,-1)", "V(135)"},
                                                       {"step", "V(1)"},
                                                       {"!(x>2)", "V(0)"},
                                                       {"x-y*x", "V(9)"},
                                                       {"x*1e3", "V(3000)"},
                                                       {".5*x", "V(1.5)"},
                                                       {"y*x*0", "V(0)"},
                                                       {"x<>y", "V(1)"},
                                                       {"x>=3 or 1/(x-3)>0", "V(1)"}};
  for (const auto& [formula, want] : cases)
    EXPECT_NE(value(formula).find(want), std::string::npos) << formula << ": " << value(formula);
  EXPECT_NE(value("1/(x-3)").find("step 1, module 1 (`A(3,-2)`): column "), std::string::npos);
  EXPECT_NE(value("log(y)").find("not finite"), std::string::npos);
}

}  // namespace
}  // namespace frond
