#include <gtest/gtest.h>

#include <filesystem>
#include <utility>

#include "grammar/corpus.h"
#include "grammar/picture.h"

namespace frond {
namespace {

using nlohmann::json;

/// A grammar file of presets/grammars, read key by key; a key that is not known fails the test.
GrammarText grammar_file(const std::filesystem::path& path) {
  std::ifstream file(path);
  const json all = json::parse(file);
  GrammarText g;
  auto rules = [](const json& list) {
    std::vector<GrammarText::Rule> texts;
    for (const json& rule : list) texts.push_back({rule.get<std::string>()});
    return texts;
  };
  for (const auto& [key, value] : all.items()) {
    if (key == "axiom")
      g.axiom = value;
    else if (key == "steps")
      g.steps = value;
    else if (key == "angle")
      g.angle = value;
    else if (key == "length")
      g.length = value;
    else if (key == "width")
      g.width = value;
    else if (key == "width_scale")
      g.width_scale = value;
    else if (key == "length_scale")
      g.length_scale = value;
    else if (key == "ignore")
      g.ignore = value;
    else if (key == "interpretation_depth")
      g.interpretation_depth = value;
    else if (key == "rules")
      g.rules = rules(value);
    else if (key == "interpretation")
      g.interpretation = rules(value);
    else if (key == "constants")
      for (const auto& [name, constant] : value.items()) g.constants.emplace_back(name, formula(constant));
    else if (key == "tropism") {
      const json& v = value["vector"];
      g.tropism = Vec3(v[0].get<float>(), v[1].get<float>(), v[2].get<float>());
      g.elasticity = value["elasticity"];
    } else
      ADD_FAILURE() << path << ": " << key;
  }
  return g;
}

TEST(Presets, AllGrammarsDraw) {
  int tried = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FROND_ROOT "/presets/grammars")) {
    SCOPED_TRACE(entry.path().filename().string());
    Result<Grammar> grammar = compile(grammar_file(entry.path()));
    ASSERT_TRUE(grammar.ok()) << grammar.errors()[0].text();
    EXPECT_TRUE(grammar->warnings.empty()) << grammar->warnings[0].text();
    Result<Figure> figure = figure_of(*grammar, grammar->text.steps, Seed{1});
    ASSERT_TRUE(figure.ok()) << figure.errors()[0].text();
    EXPECT_EQ(figure->skeleton.find_fault(), "");
    EXPECT_EQ(figure->color.size(), figure->skeleton.size());
    bool draws = figure->skeleton.size() > 0 || !figure->outlines.empty();
    EXPECT_EQ(draws, entry.path().stem() != "algae" && entry.path().stem() != "cells");
    if (const char* folder = std::getenv("FROND_PICTURES")) {
      std::ofstream file(std::string(folder) + "/" + entry.path().stem().string() + ".svg");
      file << *turtle_svg(*grammar, grammar->text.steps, Seed{1});
    }
    ++tried;
  }
  EXPECT_GE(tried, 35);
}

TEST(Presets, CellsAndFibonacciMakeTheWordsOfTheDocs) {
  auto word = [](const char* name, int steps) {
    Grammar grammar = std::move(*compile(grammar_file(FROND_ROOT "/presets/grammars/" + std::string(name))));
    return text(grammar, *derive(grammar, steps, Seed{1}));
  };
  EXPECT_EQ(word("cells.json", 1), "AB");
  EXPECT_EQ(word("cells.json", 2), "ABb");
  EXPECT_EQ(word("cells.json", 3), "ABbb");
  EXPECT_EQ(word("cells.json", 4), "ABbbb");
  std::size_t before = 1, now = 1;
  for (int steps = 0; steps < 12; ++steps) {
    EXPECT_EQ(word("algae.json", steps).size(), now);
    before = std::exchange(now, before + now);
  }
  EXPECT_EQ(word("binary_tree.json", 2), "11[1[0]0]1[0]0");
  std::ifstream shown(FROND_ROOT "/docs/gallery/fibonacci-tree.svg");
  Grammar algae = std::move(*compile(grammar_file(FROND_ROOT "/presets/grammars/algae.json")));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(shown), {}), *derivation_tree_svg(algae, 6, Seed{1}));
}

}  // namespace
}  // namespace frond
