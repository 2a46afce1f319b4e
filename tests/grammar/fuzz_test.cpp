#include <gtest/gtest.h>

#include "grammar/between.h"
#include "grammar/figure.h"
#include "grammar/import.h"
#include "grammar/picture.h"
#include "mutant.h"

namespace frond {
namespace {

/// A text of pieces picked at random: mostly wrong, now and then right.
std::string random_text(Seed seed, const std::vector<std::string>& pieces, std::uint64_t most) {
  std::string text;
  for (std::uint64_t i = 0, n = seed.bits() % most; i < n; ++i)
    text += pieces[seed.child(i).bits() % pieces.size()];
  return text;
}

const std::vector<std::string> kPieces{"A",        "B",        "F",
                                       "(",        ")",        "[",
                                       "]",        "x",        ",",
                                       "->",       " -> ",     "<",
                                       ">",        " : ",      "+",
                                       "-",        "*",        "/",
                                       "1",        "0.5",      "=",
                                       "&&",       "sin(",     "rand(0,",
                                       "A(x)",     "F(x)",     "B(x,y)",
                                       "->(0.5) ", "{",        "}",
                                       "~",        "%",        "?P(0,0,0)",
                                       "!",        "\"",       "w[",
                                       "ramp(w,",  "\u2192",   "@Gc",
                                       "^",        "$",        "x+1",
                                       "x/y",      " ",        "2",
                                       "|",        "not ",     "step",
                                       "A -> ",    "A(x) -> ", "B < A > F -> "};

const std::vector<std::string> kHeads{"A",    "A(x) : x > 0.5", "F",    "B(x,y) : x<y", "A < F", "F > [A]",
                                      "F(x)", "A < B(x,y) > A", "F > A"};
const std::vector<std::string> kGood{"A",        "F",         "A(x/2)",    "B(x,y)", "[A]",          "[+F]",
                                     "%",        "F(1/x)",    "?P(0,0,0)", "!",      "A(rand(0,1))", "~K",
                                     "{.f.+f.}", "B(1,step)", "",          "$",      "A(w[x])"};

/// A rule whose form is right; what it asks for may still be missing.
std::string random_rule(Seed seed) {
  std::string weight = seed.child("weight").bits() % 3 == 0 ? "(0.5) " : " ";
  return kHeads[seed.child("head").bits() % kHeads.size()] + " ->" + weight +
         random_text(seed.child("tail"), kGood, 6);
}

TEST(Fuzz, AnyTextIsCompiledOrRefused) {
  int right = 0;
  for (std::uint64_t i = 0; i < 30'000; ++i) {
    Seed seed{i};
    GrammarText text;
    text.axiom = i % 3 == 0 ? random_text(seed.child("axiom"), kPieces, 8) : "A(2)F[AB(1,2)]A";
    text.constants = {{"w", "[1,2,3]"}};
    for (std::uint64_t k = 0; k < 1 + i % 3; ++k) {
      Seed place = seed.child("rule", k);
      text.rules.push_back({i % 2 == 0 ? random_rule(place) : random_text(place, kPieces, 12)});
    }
    if (i % 5 == 0) text.decomposition = {{"A -> F" + random_text(seed.child("decomposition"), kGood, 3)}};
    if (i % 7 == 0) text.interpretation = {{"A -> F" + random_text(seed.child("interpretation"), kGood, 4)}};
    if (i % 11 == 0) text.ignore = "+-F";
    text.ring = i % 13 == 0;
    if (i % 4 == 0) text.mode = GrammarText::Mode::sequential;
    Result<Grammar> grammar = compile(text);
    if (!grammar) {
      for (const Error& error : grammar.errors()) ASSERT_FALSE(error.what.empty());
      continue;
    }
    ++right;
    Limits limits{2000, 100'000};
    forecast(*grammar, 4, seed, limits);
    Result<Word> word = derive(*grammar, 4, seed, limits);
    if (word) derive(*grammar, 4, seed, limits)->clear();
    Result<Figure> figure = figure_of(*grammar, 3.5, seed, limits);
    Derivation plain = begin(*grammar, seed);
    Errors errors = advance_plainly(*grammar, plain, 4, seed, limits);
    EXPECT_EQ(errors.empty(), word.ok()) << text.rules[0].text;
    if (word) {
      EXPECT_TRUE(plain.word == *word) << text.rules[0].text;
    }
  }
  EXPECT_GT(right, 300);
}

TEST(Fuzz, AnyFileIsImportedOrRefused) {
  std::vector<std::string> pieces = kPieces;
  for (const char* piece :
       {"\n", "\n", "\n", "premise: ", "generations: 3\n", "angle: ", "A=", "@\n", "3\n", "45\n"})
    pieces.emplace_back(piece);
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    std::string text = random_text(Seed{i}, pieces, 30);
    for (const char* name : {"a.ls", "a.txt"}) {
      Result<GrammarText> import = import_grammar(name, text);
      if (import && !compile(*import)) {
        EXPECT_FALSE(compile(*import).errors().empty());
      }
    }
  }
}

/// Grammars of other programs that use everything.
const std::vector<std::pair<const char*, std::string>> kOthers{
    {"a.ls",
     "# a bush\n3.5 # depth\n22\n30\n%A(3)c(2)B\nA=F(20)[+(30)'BZ]t(0.3)>A\nB={.f-f!(0.4)z:\"g}?;~(9)$|C\n"
     "C=^Z&<t\n@\n"},
    {"a.ls", "recursion 2\nangle 20\nthickness 40\nmutation 3\naxiom AF\nrule A = F[A]\nrule F = FF(2)\n"},
    {"a.txt",
     "premise: A(0)$(1,2,3)\ngenerations: 3.5\nangle: 28\nstepscale: 0.8\nRandom Scale: 5\ngravity: 0.2\n"
     "b: 2\nignore: +-\nA(i):i<b & t<9=F(i*b,0.1)[+(rand(20))TA(i+1)]J(2,0,1):0.5\nA(i)=\"!;H_?@h'#~*|K\n"
     "B<F>C=G(a)g(1)\n"},
    {"a.txt", "premise: AA\ngenerations: 4\nA:y<3|x>2=FA\nA=%\n"}};

TEST(Fuzz, AnyGrammarOfAnotherProgramIsDrawnOrRefused) {
  std::vector<std::string> pieces = kPieces;
  for (const char* piece : {"\n", "=", ":", "#", "@", "(3)", "t", "T", "J(1,2)", "g", "y", "rand(", "9e9"})
    pieces.emplace_back(piece);
  int right = 0;
  for (std::uint64_t i = 0; i < 6'000; ++i) {
    Seed seed{i};
    const auto& [name, text] = kOthers[seed.child("file").bits() % kOthers.size()];
    Result<GrammarText> import = import_grammar(name, mutant(text, pieces, seed));
    if (!import) {
      for (const Error& error : import.errors()) ASSERT_FALSE(error.what.empty());
      continue;
    }
    import->mutations = import->mutations % 50;
    Result<Grammar> grammar = compile(*import);
    if (!grammar) continue;
    ++right;
    Result<Figure> figure = figure_of(*grammar, std::min(import->growth(), 4.5), seed, Limits{2000, 100'000});
    if (!figure) {
      ASSERT_FALSE(figure.errors()[0].what.empty());
    }
  }
  EXPECT_GT(right, 500);
}

TEST(Fuzz, TheGrammarsOfOtherProgramsAreRight) {
  for (const auto& [name, text] : kOthers) {
    Result<GrammarText> import = import_grammar(name, text);
    ASSERT_TRUE(import.ok()) << import.errors()[0].text();
    Result<Grammar> grammar = compile(*import);
    EXPECT_TRUE(grammar.ok()) << grammar.errors()[0].text();
  }
}

}  // namespace
}  // namespace frond
