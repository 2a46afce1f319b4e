#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/lookalike.h"
#include "core/plain_text.h"
#include "grammar/figure.h"
#include "grammar/import.h"
#include "grammar/kind.h"

// Grammars as people collect them: by what is in a file, not by what it is called.

namespace frond {
namespace {

std::string case_text(const std::string& name) {
  std::ifstream file(FROND_ROOT "/tests/cases/" + name, std::ios::binary);
  EXPECT_TRUE(file) << name;
  return (std::stringstream() << file.rdbuf()).str();
}

std::string all(const Errors& errors) {
  std::string text;
  for (const Error& error : errors) text += error.text() + "\n";
  return text;
}

std::string word_after(const Result<GrammarText>& import, int steps) {
  if (!import) return all(import.errors());
  Result<Grammar> grammar = compile(*import);
  if (!grammar) return all(grammar.errors());
  Result<Word> word = derive(*grammar, steps, Seed{1});
  return word ? text(*grammar, *word) : all(word.errors());
}

TEST(Foreign, TheKindOfAGrammarIsWhatIsInItAndNotItsName) {
  const std::string fractint = "Koch { ; a curve\n  Angle 6\n  Axiom F--F--F\n  F=F+F--F+F\n  }\n";
  for (const char* name : {"a.l", "a.txt", "KOCH.L", "a.ls", "a"})
    EXPECT_EQ(grammar_kind(name, fractint), GrammarKind::fractint) << name;
  EXPECT_EQ(grammar_kind("a.txt", "Lsystem: 1\nAxiom: A\nendlsystem\n"), GrammarKind::cpfg);
  EXPECT_EQ(grammar_kind("a.txt", "5\n30\n20\nA\nA=F\n@\n"), GrammarKind::lparser);
  EXPECT_EQ(grammar_kind("a.l", "premise: A\nA=F\n"), GrammarKind::houdini);
  EXPECT_EQ(grammar_kind("a.txt", "# a vine\n1 3 0 0 0 0.1 -1\n2 3 0 1 0 0.1 1\n"), GrammarKind::skeleton);
  EXPECT_EQ(grammar_kind("a.txt", "{\"axiom\": \"F\"}"), GrammarKind::preset);
  EXPECT_EQ(grammar_kind("A.LS", ""), GrammarKind::lparser);
  EXPECT_EQ(grammar_kind("a.l", case_text("05-lpy-massart-ply/massart_renamed.l")), GrammarKind::cpfg);
  EXPECT_EQ(grammar_kind("a.txt", case_text("05-lpy-massart-ply/massart.lpy")), GrammarKind::cpfg);
  EXPECT_EQ(grammar_kind("a.l", case_text("04-arity-and-pairs/pair.l")), GrammarKind::cpfg);
}

TEST(Foreign, TextsOfOtherSystemsBecomeLines) {
  EXPECT_EQ(plain_text("a\r\nb\rc\n"), "a\nb\nc\n");
  EXPECT_EQ(plain_text("\xef\xbb\xbf"
                       "a\x1a left"),
            "a");
  EXPECT_EQ(plain_text(std::string_view("\xff\xfe"
                                        "A\0\x12\x22",
                                        6)),
            "A\u2212");
  EXPECT_TRUE(has_ending("BUSH.LS", ".ls"));
  EXPECT_FALSE(has_ending("ls", ".ls"));
}

TEST(Foreign, GrammarsOfDosDaysGiveTheWordOfThoseOfToday) {
  auto word = [](const std::string& name) {
    return word_after(import_grammar(name, case_text("03-dos-lparser/" + name)), 2);
  };
  EXPECT_EQ(word("BUSH.LS"), word("bush.ls"));
  EXPECT_EQ(word("bush5.ls"), word("bush5_spaces.ls"));
  EXPECT_EQ(word("bush5.ls").substr(0, 3), "F[+");
  Result<GrammarText> five = import_grammar("bush5.ls", case_text("03-dos-lparser/bush5.ls"));
  ASSERT_TRUE(five.ok());
  EXPECT_NE(all(five->notes).find("line 5: `trope` of lsuss has no effect here"), std::string::npos);
  EXPECT_NE(all(five->notes).find("line 6: `rand` of lsuss has no effect here"), std::string::npos);
}

TEST(Foreign, FilesOfLMUSeHaveNoThickness) {
  Result<GrammarText> music = import_grammar("a.ls", "3 # recursion\n10 # angle\nAB # axiom\nA=+FB\nB=AF\n");
  EXPECT_EQ(word_after(music, 1), "+FBAF");
  EXPECT_NE(all(music->notes).find("LMUSe"), std::string::npos);
  Errors errors = import_grammar("a.ls", "3\n10\nAB\nA=+FB\nB<A=F\n").errors();
  EXPECT_NE(all(errors).find("line 5: column 1: `B<A=F`: a rule with contexts"), std::string::npos)
      << all(errors);
}

TEST(Foreign, FractintsSystemsAreRead) {
  const std::string file =
      "; a collection\nKoch { ; by hand\n  Angle 6\n  Axiom f--f--f\n  f=f+f--f+f\n}\n"
      "Twig{Angle=8\nAxiom=x\nX=F[+X]F\nx=[-X]|2+\nF=FF\n}\nOdd {\nangle 5\naxiom F|@.5F@I2F@Q4G\nF=F\n}\n"
      "Free { angle 4\naxiom D\\60D/30M\n}\nBoth { angle 4\naxiom FD\\60\n}\nTurned { angle 4\naxiom "
      "F!+F\n}\n";
  auto word = [&](const char* name, int steps) {
    return word_after(import_grammar("c.l", file, name), steps);
  };
  EXPECT_EQ(word("koch", 1), "F+F--F+F--F+F--F+F--F+F--F+F");
  EXPECT_EQ(word("Twig", 1), "F[+X]F[-X]|++");
  EXPECT_EQ(word("Odd", 0), "F+(144)\"(0.5)F\"(0.5)F\"(2)f");
  EXPECT_EQ(word("Free", 0), "F+(60)F-(30)f");
  EXPECT_NE(word("Both", 0).find("each with a heading of their own"), std::string::npos);
  EXPECT_NE(word("Turned", 0).find("line 25: column 8: `!` exchanges left and right"), std::string::npos)
      << word("Turned", 0);
  EXPECT_NE(word("", 0).find("holds 6 L-systems; expected the name of one: Koch, Twig, Odd"),
            std::string::npos);
  EXPECT_NE(word("Kohc", 0).find("did you mean `Koch`?"), std::string::npos);
  Result<GrammarText> koch = import_grammar("c.l", file, "Koch");
  ASSERT_TRUE(koch.ok());
  EXPECT_DOUBLE_EQ(koch->angle, 60);
  EXPECT_EQ(koch->start_heading, DVec3(1, 0, 0));
}

TEST(Foreign, SkeletonsAreDrawnAsTheyWereMeasured) {
  Result<GrammarText> vine = import_grammar("vine.swc", case_text("07-swc-skeleton/vine.swc"));
  ASSERT_TRUE(vine.ok()) << all(vine.errors());
  Result<Grammar> grammar = compile(*vine);
  ASSERT_TRUE(grammar.ok()) << all(grammar.errors());
  Result<Figure> figure = figure_of(*grammar, 0, Seed{1});
  ASSERT_TRUE(figure.ok());
  const Skeleton& drawn = figure->skeleton;
  EXPECT_EQ(drawn.size(), 25u);  // nothing twice below forks
  std::istringstream rows(case_text("07-swc-skeleton/vine.swc"));
  for (std::string row; std::getline(rows, row);) {
    std::istringstream numbers(row);
    int id = 0, type = 0;
    double x = 0, y = 0, z = 0, radius = 0;
    if (!(numbers >> id >> type >> x >> y >> z >> radius)) continue;
    std::size_t near = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i)
      if (glm::distance(drawn.position[i], Vec3(x, y, z)) <
          glm::distance(drawn.position[near], Vec3(x, y, z)))
        near = i;
    EXPECT_LT(glm::distance(drawn.position[near], Vec3(x, y, z)), 1e-5f) << row;
    EXPECT_NEAR(drawn.radius[near], radius, 1e-6) << row;
  }
}

TEST(Foreign, AShapeThatAFormulaGivesStopsHoudinisGrowth) {
  std::string text = case_text("06-houdini-inside/dome_xyz.txt");
  const std::string premise = "premise: A(1)";
  ASSERT_EQ(text.find(premise), 0u);
  // From the foot, which lies on the ball itself, it would not grow at all.
  text.replace(0, premise.size(), "premise: F(0.1)A(1)");
  Result<GrammarText> dome = import_grammar("dome_xyz.txt", text);
  ASSERT_TRUE(dome.ok()) << all(dome.errors());
  Result<Grammar> grammar = compile(*dome);
  ASSERT_TRUE(grammar.ok()) << all(grammar.errors());
  std::vector<std::string> organs{"J"};
  Result<Figure> figure = figure_of(*grammar, dome->steps, Seed{1}, {}, organs);
  ASSERT_TRUE(figure.ok()) << all(figure.errors());
  const Vec3 middle(0, 1.2f, 0);
  const Skeleton& drawn = figure->skeleton;
  std::vector<bool> bears(drawn.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    EXPECT_LT(glm::distance(drawn.position[i], middle), 1.2f + 0.4f + 1e-5f);
    if (drawn.parent[i] != Skeleton::kRoot) bears[static_cast<std::size_t>(drawn.parent[i])] = true;
  }
  EXPECT_LE(std::count(bears.begin(), bears.end(), false), 729);
  EXPECT_GT(drawn.size(), 40u);
  EXPECT_GT(figure->sites.size(), 20u);
  for (const Site& leaf : figure->sites) EXPECT_GE(glm::distance(leaf.position, middle), 1.2f - 1e-5f);
}

TEST(Foreign, WhatIsWrongInASkeletonIsToldWithItsLine) {
  auto said = [](const std::string& text) {
    Result<GrammarText> import = import_skeleton(text);
    return import ? std::string() : all(import.errors());
  };
  EXPECT_EQ(said("# any\n2 0 0 1 0 .1 1\n1 0 0 0 0 .1 -1\n"), "");  // in any order
  EXPECT_EQ(said("1,0,0,0,0,0,-1\n\n2,0,0,1,0,0,1\n"), "");
  EXPECT_NE(said("1 0 0 0 0 .1 -1\n2 0 0 1 0 .1 7\n").find("line 2: column 1: there is no node 7"),
            std::string::npos);
  EXPECT_NE(said("1 0 0 0 0 .1 -1\n1 0 0 1 0 .1 1\n").find("is there twice"), std::string::npos);
  EXPECT_NE(said("1 0 0 0 0 .1 2\n2 0 0 1 0 .1 1\n").find("hangs from itself"), std::string::npos);
  EXPECT_NE(said("1 0 0 0 x .1 -1\n").find("line 1: column 9: `x` is no number"), std::string::npos);
  EXPECT_NE(said("").find("there is no node"), std::string::npos);
  std::string chain = "0 0 0 0 0 .1 -1\n";  // as deep as it is long
  for (int i = 1; i < 20000; ++i)
    chain += std::to_string(i) + " 0 0 " + std::to_string(i) + " 0 .1 " + std::to_string(i - 1) + "\n";
  EXPECT_EQ(said(chain), "");
}

std::string refused(GrammarText text) {
  Result<Grammar> grammar = compile(text);
  return grammar ? all(grammar->warnings) : all(grammar.errors());
}

TEST(Foreign, SignsOfWebPagesAreNamedInAxiomsRulesAndFormulas) {
  GrammarText text;
  text.axiom = "F\u2212F";
  EXPECT_NE(refused(text).find("axiom: column 2: `\u2212` (U+2212) is not `-`, which is meant"),
            std::string::npos);
  text.axiom = "F\uff3b+F]";
  EXPECT_NE(refused(text).find("axiom: column 2: `\uff3b` (U+FF3B) is not `[`"), std::string::npos);
  text.axiom = "F\u00a0F";
  EXPECT_NE(refused(text).find("U+00A0 is not a blank"), std::string::npos);
  text.axiom = "F";
  text.rules = {{"F \u2192 F\u2212[F]"}};
  EXPECT_NE(refused(text).find("rule 1: column 6: `\u2212`"), std::string::npos) << refused(text);
  text.rules = {{"F(x) : x\u22641 -> F(2\u00d7x)"}};
  EXPECT_NE(refused(text).find("is not `<=`"), std::string::npos);
  text.rules = {{"F -> F\u2212F"}};
  text.symbols = {"\u2212"};  // somebody's own symbol
  EXPECT_EQ(refused(text).find("is not"), std::string::npos);
  EXPECT_NE(all(import_houdini("premise: A\nA=F\u2212A\n").errors()).find("line 2: column 4: `\u2212`"),
            std::string::npos);
  EXPECT_NE(all(import_lparser("5\n30\n20\nA\nA=F\uff0bA\n").errors()).find("line 5: column 4: `\uff0b`"),
            std::string::npos);
}

TEST(Foreign, LettersOfOtherAlphabetsAreSymbolsAndTwinsOfLatinOnesAreTold) {
  GrammarText text;
  text.axiom = "\u03c9";
  text.rules = {{"\u03c9 -> F[+\u03c9]"}};
  EXPECT_EQ(refused(text), "");
  text.axiom = "\u0425";  // Cyrillic
  text.rules = {{"X -> F[+X]"}};
  EXPECT_NE(
      refused(text).find("axiom: column 1: `\u0425` is a letter of another alphabet that looks like `X`"),
      std::string::npos)
      << refused(text);
}

TEST(Foreign, NumbersOfParametersThatNothingRewritesAreToldWithTheirPlaces) {
  GrammarText text;
  text.axiom = "FB(1,2)";
  text.rules = {{"B(a,b,c) -> F(a)"}, {"B(a) -> f(a)"}};
  EXPECT_NE(
      refused(text).find("axiom: column 2: `B` has 2 parameters here and is rewritten with 3 (rule 1, column "
                         "1) or with 1 (rule 2, column 1) only"),
      std::string::npos)
      << refused(text);
  text.axiom = "a";
  text.rules = {{"A -> F"}};
  EXPECT_NE(refused(text).find("no rule rewrites anything of `a`"), std::string::npos);
}

TEST(Foreign, DivisionsByZeroAreToldOfTheRuleAndColumnThatDivides) {
  GrammarText text;
  text.axiom = "A(4,0)";
  text.rules = {{"A(p,q) : p/q > 1 -> F(p/q)A(p-1,q)"}, {"A(p,q) : p > 0 -> F(-p)A(p-1,q)"}};
  Result<Grammar> grammar = compile(text);
  ASSERT_TRUE(grammar.ok());
  std::string derived = all(derive(*grammar, 1, Seed{1}).errors());
  EXPECT_EQ(derived.find("rule 1: step 1, module 1 (`A(4,0)`): column 11: division by zero"), 0u) << derived;
  std::string walked = all(stats_of(*grammar, 1, Seed{1}).errors());
  EXPECT_NE(walked.find("rule 1: "), std::string::npos) << walked;
  EXPECT_NE(walked.find("column 11: division by zero"), std::string::npos) << walked;
  text.rules = {{"A(p,q) ->(p) F"}, {"A(p,q) ->(1/q) G"}};
  grammar = compile(text);
  ASSERT_TRUE(grammar.ok());
  EXPECT_EQ(all(derive(*grammar, 1, Seed{1}).errors()).find("rule 2: "), 0u);
}

TEST(Foreign, WhatHoudiniAsksOfItsInputsIsRefusedWithItsPlaceAndTheWaysRound) {
  Errors errors = import_grammar("dome.txt", case_text("06-houdini-inside/dome_in.txt")).errors();
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0].where, "line 6: column 6");
  EXPECT_EQ(errors[1].where, "line 7: column 7");
  for (const char* way : {"x, y and z", "colonized", "?E"})
    EXPECT_NE(errors[0].what.find(way), std::string::npos) << way;
}

}  // namespace
}  // namespace frond
