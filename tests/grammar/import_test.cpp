#include "grammar/import.h"

#include <gtest/gtest.h>

#include "grammar/figure.h"

namespace frond {
namespace {

std::string said(const Result<GrammarText>& import) { return import ? "" : import.errors()[0].text(); }

std::string derived(const Result<GrammarText>& import) {
  if (!import) return said(import);
  Result<Grammar> grammar = compile(*import);
  if (!grammar) return grammar.errors()[0].text();
  Result<Word> word = derive(*grammar, import->steps, Seed{import->seed}, Limits{10'000});
  return word ? text(*grammar, *word) : word.errors()[0].text();
}

/// What the turtle draws, and where and how it ends.
struct Walk {
  std::vector<double> lengths, widths;
  std::vector<int> colors;
  int polygons = 0;
  TurtleState last;
  void segment(const Segment& s, TurtleState& state) {
    lengths.push_back(glm::distance(s.from, s.to)), widths.push_back(s.width_to);
    colors.push_back(state.color);
  }
  void polygon(std::span<const DVec3> points, const TurtleState&) { polygons += points.size() == 3; }
  void end(const TurtleState& state) { last = state; }
};

Walk walked(const Result<GrammarText>& import) {
  Walk walk_of;
  if (!import) return ADD_FAILURE() << said(import), walk_of;
  Result<Grammar> grammar = compile(*import);
  if (!grammar) return ADD_FAILURE() << grammar.errors()[0].text(), walk_of;
  walk(*grammar, *derive(*grammar, import->steps, Seed{1}), Seed{1}, walk_of);
  return walk_of;
}

void expect_near(DVec3 is, DVec3 should, const std::string& word) {
  EXPECT_NEAR(glm::distance(is, should), 0, 1e-9) << word << ": " << is.x << " " << is.y << " " << is.z;
}

struct Turn {
  const char* word;
  DVec3 heading, left;
};

/// LParser, depth 0: the angle is 30 degrees, a length 100.
Result<GrammarText> lparser(const std::string& axiom) {
  return import_lparser("0\n30\n20\n" + axiom + "\nQ=Q\n@\n");
}
Result<GrammarText> houdini(const std::string& premise, const std::string& rules = "Q=Q\n") {
  return import_houdini("generations: 0\nangle: 30\npremise: " + premise + "\n" + rules);
}

constexpr double kS = 0.5, kC = 0.86602540378443865;  // of 30 degrees

TEST(LParser, Turns) {
  const DVec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const Turn turns[] = {
      {"+", y * kC - x * kS, -x * kC - y * kS},
      {"-", y * kC + x * kS, -x * kC + y * kS},
      {"+(90)", -x, -y},
      {"&", y * kC - z * kS, -x},
      {"^", y * kC + z * kS, -x},
      {"&(90)", -z, -x},
      {"<", y, -x * kC - z * kS},
      {">", y, -x * kC + z * kS},
      {"|", -y, x},
      {"%", y, x},
      {"&(90)>(90)$", -z, -x},
      {";+",
       {-std::sin(radians(30 / 0.9)), std::cos(radians(30 / 0.9)), 0},
       {-std::cos(radians(30 / 0.9)), -std::sin(radians(30 / 0.9)), 0}},
      {":(3)+", -x, -y},
      {";(3)+", -x, -y},
      // Gravity: nothing for a heading straight up, x radians for a level one.
      {"t", y, -x},
      {"&(90)t(0.5)", -z * std::cos(0.5) - y * std::sin(0.5), -x},
      {"&(30)t(0.5)", y * std::cos(radians(30.0) + 0.25) - z * std::sin(radians(30.0) + 0.25), -x},
  };
  for (const Turn& turn : turns) {
    Walk walk = walked(lparser(turn.word));
    expect_near(walk.last.heading, turn.heading, turn.word);
    expect_near(walk.last.left, turn.left, turn.word);
  }
}

TEST(LParser, LinesAreAsWideAsTheyAreLong) {
  struct {
    const char* word;
    std::vector<double> lengths, widths;
  } const lines[] = {
      {"F", {100}, {20}},
      {"Z", {50}, {10}},
      {"F(40)Z(40)", {40, 40}, {8, 8}},
      {"'F", {90}, {18}},
      {"\"(2)F", {200}, {40}},
      {"'(2)\"F", {200 / 0.9}, {40 / 0.9}},
      {"!F", {100}, {14}},
      {"?F", {100}, {20 / 0.7}},
      {"?(2)!(0.25)F", {100}, {10}},
      {"fzgF[!F]F", {100, 100, 100}, {20, 14, 20}},
  };
  for (const auto& line : lines) {
    Walk walk = walked(lparser(line.word));
    ASSERT_EQ(walk.lengths.size(), line.lengths.size()) << line.word;
    for (std::size_t i = 0; i < line.lengths.size(); ++i) {
      EXPECT_NEAR(walk.lengths[i], line.lengths[i], 1e-9) << line.word;
      EXPECT_NEAR(walk.widths[i], line.widths[i], 1e-9) << line.word;
    }
  }
  EXPECT_EQ(walked(lparser("FcFc(7)F[cF]F")).colors, (std::vector<int>{2, 3, 7, 8, 7}));
  EXPECT_EQ(walked(lparser("{.f+(120)f+(120)g}")).polygons, 1);  // g leaves no vertex
  EXPECT_NE(walked(lparser("~(20)F")).last.heading, DVec3(0, 1, 0));
  EXPECT_GT(walked(lparser("~(20)F")).last.heading.y, 0.8);
}

TEST(LParser, Words) {
  struct {
    const char* file;
    const char* word;
  } const words[] = {
      {"2\n30\n20\nA # axiom\nA=F[+A]\n@\nrest", "F[+F[+A]]"},
      {"# a comment\n\n1\n30\n20\nA B\nA=F <(20) A\nB=\n@", "F<(20)A"},
      // A parameter stays behind what its letter becomes.
      {"2\n30\n20\nA(20)\nA=FB\nB=CC", "FCC(20)"},
      {"1\n30\n20\nF(5)F\nF=F+F", "F+F(5)F+F"},
      {"1\n30\n20\nA(5)\nA=F[B]", "F[B]"},
      {"1\n30\n20\n+A\n+=-\nA=F", "-F"},
      {"recursion 1\nangle 20\nthickness 50\naxiom A\nrule A = FA", "FA"},
  };
  for (const auto& [file, word] : words) EXPECT_EQ(derived(import_lparser(file)), word) << file;
  Result<GrammarText> named =
      import_lparser("angle 20\nthickness 50\nshape 1\naxiom A\nrule A=FA\nrule A=F\n");
  ASSERT_TRUE(named.ok()) << said(named);
  EXPECT_EQ(named->length, 1);
  ASSERT_EQ(named->notes.size(), 2u);
  EXPECT_EQ(named->notes[0].text(), "line 3: `shape` has no effect here");
  EXPECT_EQ(compile(*named)->warnings.size(), 2u);
}

TEST(LParser, AFractionOfTheDepthIsHowFarTheLastStepHasGrown) {
  Result<GrammarText> import = import_lparser("2.5\n30\n20\nA\nA=FA\n");
  EXPECT_EQ(import->steps, 3);
  EXPECT_DOUBLE_EQ(import->last_step, 0.5);
  EXPECT_DOUBLE_EQ(import->growth(), 2.5);
  EXPECT_NEAR(stats_of(*compile(*import), import->growth(), Seed{1})->total_length, 250, 1e-6);
  EXPECT_DOUBLE_EQ(import_lparser("2\n30\n20\nA\nA=FA\n")->growth(), 2);
}

TEST(LParser, WhatCannotBeHadIsRefused) {
  const char* file = "1\n30\n20\nA\nA=FA\n";
  struct {
    std::string file, what;
  } const faults[] = {
      {"1\n30\n20\nA\nA=FA\nnonsense\n", "line 6: column 1: `nonsense` is no rule"},
      {"1\n30\n20\nA\nA=F(x)A\n", "line 5: column 4: `(x)`: a parameter in ( ) is a number"},
      {"1\n30\n20\nA\nA=F(2\n", "line 5: column 4: `(2`"},
      {"1\n30\n20\nA\n<=F\n", "line 5: column 1: `<=F`: what this sign means cannot be rewritten"},
      {"1e99\n30\n20\nA\nA=FA\n", "line 1: column 1: `1e99`"},
      {"inf\n30\n20\nA\nA=FA\n", "line 1: column 1: `inf`"},
      {"1\nx\n20\nA\nA=FA\n", "line 2: column 1: `x`: the angle is a number"},
      {"1\n30\n0\nA\nA=FA\n", "line 3: column 1: `0`: the thickness is more than 0"},
      {"recursion 1\naxiom A\nrule A=F\ndepth 3\n", "line 4: column 1: `depth` is no keyword"},
      {"angle 3\nrule A=F\n", "there is no axiom"},
      {"1\n30\n", "some are missing"},
  };
  EXPECT_EQ(said(import_lparser(file)), "");
  for (const auto& fault : faults)
    EXPECT_TRUE(said(import_lparser(fault.file)).find(fault.what) != std::string::npos)
        << fault.file << said(import_lparser(fault.file));
}

TEST(Houdini, Turns) {
  const DVec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const Turn turns[] = {
      {"+", y * kC + x * kS, -x * kC + y * kS},
      {"-", y * kC - x * kS, -x * kC - y * kS},
      {"&", y * kC - z * kS, -x},
      {"^", y * kC + z * kS, -x},
      {"\\", y, -x * kC + z * kS},
      {"/", y, -x * kC - z * kS},
      {"|", -y, x},
      {"*", y, x},
      {"&(90)\\(90)$", -z, -x},
      {"$(5,0,0)", x, -z},
      {";(3)+", x, y},
      {"@(0.5)@(0.5)-", {-kC, -kS, 0}, {kS, -kC, 0}},
      {"T(1)", y, -x},
      {"&(90)T(0.5)", -z * std::cos(0.5) - y * std::sin(0.5), -x},
      {"^(90)\\(90)T(0.5)", z * std::cos(0.5) - y * std::sin(0.5), {0, 0, 0}},
      {"~(0)", y, -x},
      {"F[+F]F%", y, -x},
  };
  for (const Turn& turn : turns) {
    Walk walk = walked(houdini(turn.word));
    expect_near(walk.last.heading, turn.heading, turn.word);
    if (turn.left != DVec3(0)) expect_near(walk.last.left, turn.left, turn.word);
  }
}

TEST(Houdini, Lines) {
  struct {
    const char* word;
    std::vector<double> lengths, widths;
  } const lines[] = {
      {"F", {1}, {0.1}},
      {"H", {0.5}, {0.1}},
      {"F(3,2)F", {3, 1}, {2, 0.1}},  // the width is that of one line
      {"F(3,2,4,4,1)", {3}, {2}},
      {"H(4)", {2}, {0.1}},
      {"G(2)fhF", {2, 1}, {0.1, 0.1}},
      {"\"F_F", {0.5, 1}, {0.1, 0.1}},
      {"\"(3)F_(3)F", {3, 1}, {0.1, 0.1}},
      {"!F?F", {1, 1}, {0.05, 0.1}},
      {"!(2)F?(4)F", {1, 1}, {0.2, 0.05}},
      {"g(1)F[g-F]", {1, 1}, {0.1, 0.1}},
  };
  for (const auto& line : lines) {
    Walk walk = walked(houdini(line.word));
    ASSERT_EQ(walk.lengths.size(), line.lengths.size()) << line.word;
    for (std::size_t i = 0; i < line.lengths.size(); ++i) {
      EXPECT_NEAR(walk.lengths[i], line.lengths[i], 1e-9) << line.word;
      EXPECT_NEAR(walk.widths[i], line.widths[i], 1e-9) << line.word;
    }
  }
  EXPECT_EQ(walked(houdini("hF")).last.position.y, 1.5);
  EXPECT_EQ(walked(houdini("F'(0.1)F#F")).colors, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(walked(houdini("{.f+(120)f+(120)}")).polygons, 1);
}

TEST(Houdini, Words) {
  struct {
    const char* list;
    const char* word;
  } const words[] = {
      {"premise: A(0)\ngenerations: 3\nb: 2\nA(i):i<2=F(i*b)[+A(i+1)]:1\nA(i):i==2=K\nF(l)=F(l+1)\n",
       "F(2)[+F(3)[+K]]"},
      // The number of the step is the time.
      {"premise: l\ngenerations: 3\nb: 3\nl:t<b=l+r+\nr:t<b=-l-r\nl=F\nr=F\n", "F+F++-F-F+"},
      {"premise: ABC\nA<B>C=DOG\n", "ADOGC"},
      {"premise: A+B\nignore: +-\nA<B=X\n", "A+X"},
      {"premise: A(3)\nA(n):n>1 & n<5 | n=9=B(min(n,2)^2)\n", "B(4)"},
      {"premise: A\nangle: 20\nvarc: 3\nA=F(a*c)\n", "F(60)"},
      {"premise: A\ngravity: 0.3\nA=F(T)\n", "F(0.3)"},
      {"premise: A\nA=J(2,0,5)K(,,4)M\n", "J(2)KM"},
      {"premise: A\nA=F(rand(0)+1)\n", "F(1)"},
      {"premise: A\nA=B:1\nA=C:0\n", "B"},
      {"premise: AAA\nA=B:0\n", "AAA"},
      {"Premise: A\nGenerations: 2\nStep Size: 2\nRandom Seed: 4\nA=FA\n", "FFA"},
  };
  for (const auto& [list, word] : words) EXPECT_EQ(derived(import_houdini(list)), word) << list;
}

TEST(Houdini, ProbabilitiesLeaveTheRestAsItIs) {
  Result<GrammarText> import = import_houdini("premise: " + std::string(400, 'A') + "\nA=B:0.25\nA=C:0.25\n");
  std::string word = derived(import);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(word, 'A')), 200, 40);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(word, 'B')), 100, 35);
}

TEST(Houdini, RulesSeeWhereTheTurtleIs) {
  std::string list = "premise: A\ngenerations: 5\nstepsize: 1\nA:y<2.5=F[+J]A\nA=K\n";
  // The questions stay where rules may ask again.
  EXPECT_EQ(derived(import_houdini(list)), "F[+J]F[+J]F[+J]K");
  Walk walk = walked(import_houdini(list));
  EXPECT_EQ(walk.lengths.size(), 3u);
  EXPECT_EQ(derived(import_houdini("premise: A(1)\ngenerations: 3\nA(i):y<1=F(i)A(i+1)\nA(n):y>=1=F(9)B\n")),
            "F(1)F(9)B");
  EXPECT_NE(said(import_houdini("premise: A\nA:x>1=F\nA<B=C\n")).find("line 3: column 1: x, y and z cannot"),
            std::string::npos);
}

TEST(Houdini, SymbolsHaveAnAge) {
  EXPECT_EQ(derived(import_houdini("premise: A\ngenerations: 3\nA:g>=2=B\n")), "B");
  EXPECT_EQ(derived(import_houdini("premise: A\ngenerations: 2\nA:g>=2=B\n")), "A(2)");
  // What is replaced is young again; what stays by chance grows older; parameters come before the age.
  EXPECT_EQ(derived(import_houdini("premise: A\ngenerations: 2\nA=F(g+1)A\n")), "F(1)F(1)A(0)");
  EXPECT_EQ(derived(import_houdini("premise: A(5)\ngenerations: 3\nA(i):g<2=A(i):0\nA(i):g==2=F(i)\n")),
            "F(5)");
  EXPECT_NE(said(import_houdini("premise: AB\nA<B:g>1=F\n")).find("line 2: column 1: g cannot"),
            std::string::npos);
  EXPECT_NE(said(import_houdini("premise: F(g)A\nA=F\n")).find("the premise cannot use"), std::string::npos);
}

TEST(Houdini, ParametersThatAreLeftOutAreZero) {
  EXPECT_EQ(derived(import_houdini("premise: A\nA(i,j)=F(i+1)B(j)\n")), "F(1)B(0)");
  EXPECT_EQ(derived(import_houdini("premise: A(,2)A(3)\nA(i,j)=F(i)F(j)\n")), "F(0)F(2)F(3)F(0)");
  // Not where a rule is for what is given, nor for symbols of the turtle.
  EXPECT_EQ(derived(import_houdini("premise: A(1)FF(1)\nA(i)=B\nA(i,j)=C\nF(i,j)=D\n")), "BFF(1)");
}

TEST(Houdini, ValuesOfTheNode) {
  Result<GrammarText> import = import_houdini(
      "premise: A\nGenerations: 2.25\nstepinit: 2\nStep Size Scale: 0.8\nthickinit: 0.3\nthickscale: 0.6\n"
      "anglescale: 0.7\nRandom Scale: 10\nangle: 40\nrandseed: 9\nrows: 4\nA=\"!;FJ(1,2)g#(0.2)T(1)A\n");
  ASSERT_TRUE(import.ok()) << said(import);
  EXPECT_DOUBLE_EQ(import->growth(), 2.25);
  EXPECT_EQ(import->length, 2);
  EXPECT_EQ(import->length_scale, 0.8);
  EXPECT_EQ(import->width, 0.3);
  EXPECT_EQ(import->width_scale, 0.6);
  EXPECT_EQ(import->angle_scale, 0.7);
  EXPECT_DOUBLE_EQ(import->length_jitter, 0.1);
  EXPECT_DOUBLE_EQ(import->angle_jitter, 4);
  EXPECT_EQ(import->seed, 9u);
  EXPECT_EQ(import->notes.size(), 5u);  // rows, the group, colours, stamps, gravity
  EXPECT_EQ(import_houdini("premise: A\nA=\"F\n")->notes[0].what, "`stepscale` is not given; 0.5 is taken");
  EXPECT_EQ(import_houdini("premise: A\nA=F\n")->angle, 28);
  EXPECT_EQ(derived(import_houdini("premise: A\nA=FT\ngravity: 0.2\n")), "FT");
}

TEST(Houdini, WhatCannotBeHadIsRefused) {
  struct {
    const char* list;
    const char* what;
  } const faults[] = {
      {"premise: A\nA=FA\nnonsense\n", "line 3: column 1: `nonsense` is neither"},
      {"premise: A\nA=FTA\n", "`T` takes the gravity of the node"},
      {"premise: A\nA:in(1,2,3)=F\n", "line 2: column 3: `in` asks whether a place"},
      {"premise: A\nA=F(pic(0,0,1))\n", "line 2: column 5: `pic` reads a picture"},
      {"premise: A\nA=F(chan(2))\n", "line 2: column 5: `chan` reads a channel"},
      {"premise: A\nA=F(,2)\n", "line 2: column 5: `F(,2)` leaves out a parameter"},
      {"premise: A\nA=a(\"Cd\",1,0,0)F\n", "line 2: column 3: `a(\"…\")` names an attribute"},
      {"premise: A\nA=`strdup(\"F\")`\n", "line 2: column 3: what stands in backquotes"},
      {"premise: A\nA=F(noise(2))\n", "there is no function `noise`"},
      {"premise: A\nA=F(2\n", "line 2: column 4: a `)` is missing"},
      {"A=F\n", "there is no `premise: …`"},
      {"#include <lpfgall.h>\nmodule A(float);\nAxiom: A(1);\n",
       "there is no rule `A=…`; this is not a Houdini"},
      {"premise: A\ngenerations: 1e300\nA=FA\n", "line 2: column 1: `generations"},
      {"premise: A\nseed: -5\nA=FA\n", "line 2: column 1: `seed"},
  };
  for (const auto& [list, what] : faults) {
    std::string error = derived(import_houdini(list));
    EXPECT_NE(error.find(what), std::string::npos) << list << error;
  }
}

}  // namespace
}  // namespace frond
