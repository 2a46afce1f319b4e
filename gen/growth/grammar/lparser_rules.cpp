#include "grammar/lparser_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "grammar/import_text.h"

namespace frond {

namespace {

/// A rule of one letter, without weight or condition. The modules of its successor have their parameters.
struct LetterRule {
  std::size_t index = 0;  ///< of the rule in the grammar
  char letter = 0;
  std::vector<std::string> modules;
};

std::vector<std::string> modules_of(std::string_view word) {
  std::vector<std::string> modules;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (word[i] == ' ' || word[i] == '\t') continue;
    std::size_t end = i + 1;
    if (end < word.size() && word[end] == '(') end = std::min(word.find(')', end), word.size() - 1) + 1;
    modules.emplace_back(word.substr(i, end - i));
    i = end - 1;
  }
  return modules;
}

std::vector<LetterRule> letter_rules(const GrammarText& text) {
  std::vector<LetterRule> rules;
  for (std::size_t i = 0; i < text.rules.size(); ++i) {
    std::string_view rule = text.rules[i].text;
    std::size_t arrow = std::min(rule.find("->"), rule.size());
    std::string_view letter = trim(rule.substr(0, arrow)),
                     successor = trim(rule.substr(std::min(arrow + 2, rule.size())));
    if (letter.size() == 1 && arrow < rule.size() && !successor.starts_with('('))
      rules.push_back({i, letter[0], modules_of(successor)});
  }
  return rules;
}

std::string rule_text(std::string_view predecessor, const std::vector<std::string>& modules) {
  return fmt::format("{} -> {}", predecessor, fmt::join(modules, ""));
}

// Mutation. The kinds of change are those of LParser, after Todd and Latham 1992.

/// A module of a successor.
struct SuccessorPlace {
  std::size_t rule, module;
};

template <class Test>
std::vector<SuccessorPlace> places_where(const std::vector<LetterRule>& rules, const Test& test) {
  std::vector<SuccessorPlace> places;
  for (std::size_t r = 0; r < rules.size(); ++r)
    for (std::size_t m = 0; m < rules[r].modules.size(); ++m)
      if (test(rules[r].modules[m][0])) places.push_back({r, m});
  return places;
}

/// Exchanges one of the letters that stand in pairs for the other of its pair.
void exchange(std::vector<LetterRule>& rules, std::string_view pairs, Seed seed) {
  auto paired = [&](char letter) { return pairs.find(letter) != pairs.npos; };
  std::vector<SuccessorPlace> places = places_where(rules, paired);
  if (places.empty()) return;
  SuccessorPlace place = places[seed.bits() % places.size()];
  char& letter = rules[place.rule].modules[place.module][0];
  letter = pairs[pairs.find(letter) ^ 1];
}

/// Puts the letter of another rule in the place of one of a letter with a rule.
void replace(std::vector<LetterRule>& rules, Seed seed) {
  char from = rules[seed.child("from").bits() % rules.size()].letter;
  std::vector<char> others;
  for (const LetterRule& rule : rules)
    if (rule.letter != from) others.push_back(rule.letter);
  std::vector<SuccessorPlace> places = places_where(rules, [&](char letter) { return letter == from; });
  if (others.empty() || places.empty()) return;
  SuccessorPlace place = places[seed.child("place").bits() % places.size()];
  rules[place.rule].modules[place.module][0] = others[seed.child("to").bits() % others.size()];
}

void mutate(std::vector<LetterRule>& rules, Seed seed) {
  std::string letter(1, rules[seed.child("letter").bits() % rules.size()].letter);
  std::vector<std::string>& modules = rules[seed.child("rule").bits() % rules.size()].modules;
  switch (seed.child("kind").bits() % 6) {
    case 0:
      modules.push_back(letter);
      return;
    case 1: {
      auto at = static_cast<std::ptrdiff_t>(seed.child("at").bits() % (modules.size() + 1));
      modules.insert(modules.begin() + at, {"[", letter, "]"});
      return;
    }
    case 2:
      return exchange(rules, "+-&^><|%:;'\"", seed.child("place"));
    case 3:
      return exchange(rules, "FZfz!?", seed.child("place"));
    default:  // twice as likely as the others
      return replace(rules, seed);
  }
}

/// Rules for letters that a parameter follows.
void hand_down(GrammarText& text, const std::vector<LetterRule>& rules) {
  std::array<bool, 256> given{};
  auto mark = [&](char letter) { return !std::exchange(given[static_cast<unsigned char>(letter)], true); };
  auto note = [&](const std::vector<std::string>& modules) {
    for (const std::string& module : modules)
      if (module.size() > 1) mark(module[0]);
  };
  note(modules_of(text.axiom));
  for (const LetterRule& rule : rules) note(rule.modules);
  auto is_given = [&](const LetterRule& rule) { return given[static_cast<unsigned char>(rule.letter)]; };
  auto takes = [&](const LetterRule& rule) {
    return !rule.modules.empty() && rule.modules.back().size() == 1 && rule.modules.back() != "]";
  };
  for (bool more = true; more;) {
    more = false;
    for (const LetterRule& rule : rules)
      if (is_given(rule) && takes(rule)) more |= mark(rule.modules.back()[0]);
  }
  for (const LetterRule& rule : rules) {
    if (!is_given(rule)) continue;
    std::vector<std::string> modules = rule.modules;
    if (takes(rule)) modules.back() += "(x)";
    GrammarText::Rule copy = text.rules[rule.index];
    if (copy.where.empty()) copy.where = fmt::format("rule {}", rule.index + 1);
    copy.text = rule_text(std::string(1, rule.letter) + "(x)", modules);
    text.rules.push_back(std::move(copy));
  }
}

}  // namespace

GrammarText mutated(GrammarText text) {
  if (text.mutations == 0 || text.dialect != Dialect::lparser) return text;
  std::vector<LetterRule> rules = letter_rules(text);
  Seed seed = Seed{text.seed}.child("mutation");
  int count = std::exchange(text.mutations, 0);
  if (rules.empty()) return text;
  for (int i = 0; i < count; ++i) mutate(rules, seed.child(static_cast<std::uint64_t>(i)));
  for (const LetterRule& rule : rules)
    text.rules[rule.index].text = rule_text(std::string(1, rule.letter), rule.modules);
  return text;
}

GrammarText lparser_rules(GrammarText text) {
  text = mutated(std::move(text));
  if (text.dialect == Dialect::lparser) hand_down(text, letter_rules(text));
  return text;
}

Result<Grammar> compile(const GrammarText& text) {
  Result<Grammar> grammar = compile_plainly(lparser_rules(text));
  // What is compiled once more begins with the rules as they were written.
  if (grammar) grammar->text.rules = text.rules, grammar->text.mutations = text.mutations;
  return grammar;
}

}  // namespace frond
