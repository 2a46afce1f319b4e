#include "grammar/derive.h"

#include <gtest/gtest.h>

#include <map>

#include "grammar/corpus.h"
#include "grammar/sha256.h"

namespace frond {
namespace {

using nlohmann::json;

Grammar must_compile(const GrammarText& text) {
  Result<Grammar> grammar = compile(text);
  if (!grammar) {
    for (const Error& error : grammar.errors()) ADD_FAILURE() << error.text();
    return {};
  }
  return std::move(*grammar);
}

std::string names(const Grammar& grammar, const Word& word) {
  std::string out;
  for (SymbolId id : word.symbols) out += grammar.symbols[id].name;
  return out;
}

/// A module string cut into names and numbers, so that numbers can be compared with tolerance.
void expect_same(const std::string& got, const std::string& want, double tolerance) {
  if (got == want) return;
  std::size_t i = 0, j = 0;
  auto number = [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == 'e' || c == '+'; };
  int depth = 0;
  while (i < got.size() && j < want.size()) {
    if (depth > 0 && number(got[i]) && number(want[j])) {
      std::size_t a = 0, b = 0;
      double x = std::stod(got.substr(i, 40), &a), y = std::stod(want.substr(j, 40), &b);
      ASSERT_NEAR(x, y, tolerance) << got << "\n" << want;
      i += a, j += b;
      continue;
    }
    ASSERT_EQ(got[i], want[j]) << got << "\n" << want;
    depth += got[i] == '(' ? 1 : got[i] == ')' ? -1 : 0;
    ++i, ++j;
  }
  EXPECT_EQ(got.size() - i, want.size() - j) << got << "\n" << want;
}

void check_word(const Grammar& grammar, const Word& word, const json& expected) {
  std::string all = names(grammar, word);
  EXPECT_EQ(word.size(), expected.value("modules", word.size()));
  std::string hash = sha256(all);
  EXPECT_EQ(hash, expected.value("names_sha256", hash));
  if (expected.contains("counts")) {
    std::map<std::string, std::size_t> found;
    for (const auto& [name, times] : counts(grammar, word)) found[name] = times;
    EXPECT_EQ(json(found), expected["counts"]);
  }
  double tolerance = expected.value("param_abs_tol", 1e-9);
  if (expected.contains("string")) expect_same(text(grammar, word), expected["string"], tolerance);
  if (!expected.contains("param_sums")) return;
  std::map<std::string, std::vector<double>> sums;
  const double* parameter = word.parameters.data();
  for (SymbolId id : word.symbols) {
    const Symbol& symbol = grammar.symbols[id];
    auto& sum = sums[symbol.name];
    sum.resize(std::max(sum.size(), static_cast<std::size_t>(symbol.arity)));
    for (int i = 0; i < symbol.arity; ++i) sum[static_cast<std::size_t>(i)] += *parameter++;
  }
  for (const auto& [name, values] : expected["param_sums"].items()) {
    ASSERT_EQ(sums[name].size(), values.size()) << name;
    for (std::size_t i = 0; i < values.size(); ++i) {
      double want = values[i];
      EXPECT_NEAR(sums[name][i], want, 1e-9 * std::max(1.0, std::abs(want))) << name;
    }
  }
}

TEST(Derive, KnownAnswers) {
  int tried = 0;
  for (const json& c : corpus()) {
    std::string group = c["group"];
    if (!c.contains("rules") || group == "stochastic" || group == "turtle" ||
        c["name"] == "query-result-shape")
      continue;
    SCOPED_TRACE(c["name"].get<std::string>());
    ++tried;
    Grammar grammar = must_compile(grammar_of(c));
    Result<Word> word = derive(grammar, c["n"], Seed{1});
    ASSERT_TRUE(word.ok()) << word.errors()[0].text();
    const json& expected = c["expected"];
    check_word(grammar, *word, expected);
    if (expected.contains("interpreted"))
      check_word(grammar, interpret(grammar, *word, Seed{1}), expected["interpreted"]);
    const json earlier = expected.value("earlier_steps", json::object());
    for (const auto& [step, string] : earlier.items())
      expect_same(text(grammar, *derive(grammar, std::stoi(step), Seed{1})), string, 1e-9);
    json by_step = expected.value("strings_by_step", json::array());
    for (std::size_t i = 0; i < by_step.size(); ++i)
      EXPECT_EQ(text(grammar, *derive(grammar, static_cast<int>(i) + 1, Seed{1})), by_step[i]);
  }
  EXPECT_GE(tried, 76);
}

TEST(Derive, QuestionsAreAnsweredBetweenSteps) {
  for (const json& c : corpus()) {
    if (c["name"] != "query-result-shape") continue;
    Grammar grammar = must_compile(grammar_of(c));
    for (const auto& [step, string] : c["expected"]["filled_steps"].items())
      expect_same(text(grammar, *derive(grammar, std::stoi(step), Seed{1})), string, 1e-9);
  }
}

TEST(Derive, ChanceKeepsTheMeans) {
  for (const json& c : corpus()) {
    if (c["group"] != "stochastic") continue;
    SCOPED_TRACE(c["name"].get<std::string>());
    Grammar grammar = must_compile(grammar_of(c));
    const json& expected = c["expected"];
    int runs = expected["runs"];
    std::map<std::string, double> sums;
    for (int run = 0; run < runs; ++run)
      for (const auto& [name, times] : counts(grammar, *derive(grammar, c["n"], Seed{7}.child(run))))
        sums[name] += static_cast<double>(times);
    for (const auto& [name, stat] : expected["per_symbol_counts"].items())
      EXPECT_NEAR(sums[name] / runs, stat["mean"].get<double>(),
                  stat["tolerance_5sigma_mean_of_runs"].get<double>())
          << name;
  }
}

TEST(Derive, SameSeedSameWordAndStepsMayBeShared) {
  for (const json& c : corpus()) {
    if (!c.contains("rules") || c["group"] == "turtle") continue;
    SCOPED_TRACE(c["name"].get<std::string>());
    Grammar grammar = must_compile(grammar_of(c));
    int n = c["n"];
    Derivation state = begin(grammar, Seed{5});
    EXPECT_TRUE(advance(grammar, state, n / 2, Seed{5}).empty());
    EXPECT_TRUE(advance(grammar, state, n - n / 2, Seed{5}).empty());
    EXPECT_TRUE(state.word == *derive(grammar, n, Seed{5}));
  }
}

}  // namespace
}  // namespace frond
