#include "grammar/import.h"

#include <gtest/gtest.h>

#include "grammar/figure.h"

namespace frond {
namespace {

std::string derived(const Import& import) {
  Result<Grammar> grammar = compile(import.grammar);
  if (!grammar) return grammar.errors()[0].text();
  return text(*grammar, *derive(*grammar, import.grammar.steps, Seed{import.grammar.seed}));
}

TEST(Import, LParserAlphabet) {
  Result<Import> import = import_lparser("# a bush\n1\n30\n20\n>Aa\n\nA=Z<(20)F[%!'A]\na=F~(10)\n@\nrest");
  ASSERT_TRUE(import.ok()) << import.errors()[0].text();
  EXPECT_EQ(import->grammar.angle, 30);
  EXPECT_DOUBLE_EQ(import->grammar.width, 0.2);
  EXPECT_EQ(derived(*import), "/Z\\(20)F[/(180)@w(0.7)\"(0.9)A]F@~(10)");
  Grammar grammar = std::move(*compile(import->grammar));
  EXPECT_DOUBLE_EQ(stats_of(grammar, 1, Seed{1})->total_length, 2.5);
}

TEST(Import, HoudiniRules) {
  Result<Import> import = import_houdini(
      "premise: A(0)\nangle: 28\ngenerations: 3\nb: "
      "2\nA(i):i<2=F(i*b)[+A(i+1)]:0.5\nA(i):i==2=K\nF(l)=F(l+1)\n");
  ASSERT_TRUE(import.ok()) << import.errors()[0].text();
  EXPECT_EQ(import->grammar.dialect, Dialect::houdini);
  EXPECT_EQ(derived(*import), "F(2)[+F(3)[+K]]");
  EXPECT_TRUE(import->notes.empty());
}

std::string said(const Result<Import>& import) { return import ? "" : import.errors()[0].text(); }

TEST(Import, WhatCannotBeHadIsRefused) {
  EXPECT_NE(said(import_houdini("premise: A\nA=FA\nnonsense\n")).find("line 3: `nonsense` is neither"),
            std::string::npos);
  EXPECT_NE(said(import_houdini("premise: A\nA=FTA\n")).find("line 2: `T` bends"), std::string::npos);
  EXPECT_NE(said(import_lparser("1\n30\n20\nA\nA=FA\nnonsense\n")).find("line 6: `nonsense`"),
            std::string::npos);
  EXPECT_NE(said(import_lparser("1\n30\n20\nA\nA=Ft(0.2)A\n")).find("line 5: `t` bends"), std::string::npos);
}

TEST(Import, NumbersThatNoCountCanHoldAreRefused) {
  EXPECT_NE(said(import_lparser("1e99\n30\n20\nA\nA=FA\n")).find("line 1: `1e99`"), std::string::npos);
  EXPECT_NE(said(import_lparser("inf\n30\n20\nA\nA=FA\n")).find("are numbers"), std::string::npos);
  EXPECT_NE(said(import_houdini("generations: 1e300\nA=FA\n")).find("line 1: `generations"),
            std::string::npos);
  EXPECT_NE(said(import_houdini("seed: -5\nA=FA\n")).find("line 1: `seed"), std::string::npos);
}

}  // namespace
}  // namespace frond
