#include "scene/wrong_presets.h"

// Presets whose own grammars are wrong, each with all that is said of it.
namespace frond {
namespace {

// Own grammars: found when all else is right.
const WrongPreset kWrongGrammars[] = {
    {"An empty grammar",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": ""}]})",
     {},
     {R"(3:15: /organisms/0/grammar: found the text ""; expected an object)"}},
    {"An empty rule",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": [""]}}]})",
     {},
     {"3:26: /organisms/0/grammar/rules/0: column 1: no arrow; a rule is `predecessor -> successor`; in ``"}},
    {"A rule without arrow",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": ["F -> FF",
     "F = F"]}}]})",
     {},
     {"4:6: /organisms/0/grammar/rules/1: column 6: no arrow; a rule is `predecessor -> successor`; in `F = "
      "F`"}},
    {"An unbalanced bracket",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"axiom": "F]", "rules": [
     "F -> F[+F",
     {"rule": "A -> F]"}]}}]})",
     {},
     {"3:25: /organisms/0/grammar/axiom: column 2: this `]` closes no `[`; remove it or open the branch; in "
      "`F]`",
      "4:6: /organisms/0/grammar/rules/0: column 7: this `[` is not closed; add a `]`; in `F -> F[+F`",
      "5:6: /organisms/0/grammar/rules/1: column 7: this `]` closes no `[`; remove it or open the branch; in "
      "`A -> F]`"}},
    {"Brackets whose drawings are none",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": ["0 -> F"],
     "interpretation": ["[ -> [+",
       "] -> -",
       "[ : 1 > 2 -> ["]}}]})",
     {},
     {"5:8: /organisms/0/grammar/interpretation/1: column 1: what is drawn for `]` holds a `]` of its own; "
      "add "
      "it; in `] -> -`",
      "6:8: /organisms/0/grammar/interpretation/2: column 1: a bracket is always drawn alike; remove the "
      "condition and the weight; in `[ : 1 > 2 -> [`"}},
    {"An organ without its grammar",
     R"({"organisms": [
  {"kind": "plant", "grammar": {"axiom": "F~L"}, "organs": [{"symbol": "L",
   "shape": "grammar"}]}]})",
     {},
     {"2:61: /organisms/0/organs/0/grammar: is missing; the shape \"grammar\" needs it"}},
    {"A grammar of an organ of another shape",
     R"({"organisms": [
  {"kind": "plant", "grammar": {"axiom": "F~L"}, "organs": [{"symbol": "L",
   "grammar": {"axiom": "F"}}]}]})",
     {},
     {"3:15: /organisms/0/organs/0/grammar: needs \"shape\": \"grammar\""}},
    {"Flowers without their diagram, with what does not go together, and of no organ",
     R"({"organisms": [
  {"kind": "plant", "grammar": {"axiom": "F~W"}, "organs": [{"symbol": "W", "shape": "diagram"}]},
  {"kind": "plant", "grammar": {"axiom": "F~W"}, "organs": [{"symbol": "W", "shape": "diagram", "diagram": {"whorls": [
    {"part": "petals", "tube": [[0, 0.1], [1, 0.2]]}]}}]},
  {"kind": "plant", "grammar": {"axiom": "F~I"}, "organs": [{"symbol": "I", "shape": "inflorescence",
    "inflorescence": {"type": "raceme",
      "flower": "W"}}]}]})",
     {},
     {"2:61: /organisms/0/organs/0/diagram: is missing; the shape \"diagram\" needs it",
      "4:32: /organisms/1/organs/0/diagram/whorls/0/tube: needs fused above 0",
      "7:17: /organisms/2/organs/0/inflorescence/flower: found \"W\"; organs has none with that symbol"}},
    {"A wrong grammar of an organ",
     R"({"organisms": [
  {"kind": "plant", "grammar": {"axiom": "F~L"}, "organs": [{"symbol": "L",
   "shape": "grammar", "grammar": {"rules": [
     "F -> F[+F"]}}]}]})",
     {},
     {"4:6: /organisms/0/organs/0/grammar/rules/0: column 7: this `[` is not closed; add a `]`; in `F -> "
      "F[+F`"}},
    {"Grammars of organs that draw too much, nothing, or organs",
     R"({"organisms": [
  {"kind": "plant", "grammar": {"axiom": "F~L"}, "organs": [{"symbol": "L", "shape": "grammar",
    "grammar": {"steps": 30, "rules": ["F -> FF"]}}]},
  {"kind": "plant", "grammar": {"axiom": "F~L"}, "organs": [{"symbol": "L", "shape": "grammar",
    "grammar": {"axiom": "A"}}]},
  {"kind": "plant", "grammar": {"axiom": "F~L"}, "organs": [{"symbol": "L", "shape": "grammar",
    "grammar": {"axiom": "F~K"}}]}]})",
     {},
     {"3:16: /organisms/0/organs/0/grammar: draws 262144 modules or segments by step 18; an organ has 200000 "
      "at "
      "most",
      "5:16: /organisms/1/organs/0/grammar: draws nothing: its turtle meets no F and no outline",
      "7:16: /organisms/2/organs/0/grammar: places an organ \"K\"; expected lines and outlines alone"}},
    {"An unknown function",
     R"~({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": [
     "F(x) -> F(sine(x))"]}}]})~",
     {},
     {"4:6: /organisms/0/grammar/rules/0: column 11: there is no function `sine`; did you mean `sin`?; in "
      "`F(x) -> F(sine(x))`"}},
    {"An unknown variable",
     R"~({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": ["F(x) -> F(y)"], "constants": {"a": "b + 1", "2c": 1}}}]})~",
     {},
     {"3:26: /organisms/0/grammar/rules/0: column 11: `y` is not a parameter of the rule, nor a constant; "
      "known are x; in `F(x) -> F(y)`",
      "3:56: /organisms/0/grammar/constants: `2c` is not a name; use letters, digits and _",
      "3:62: /organisms/0/grammar/constants/a: column 1: `b` is not a parameter of the rule, nor a constant; "
      "declare it in `constants`; in `b + 1`"}},
    {"Bad rules of every list",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": [{"rule": "F -> FF", "limit": 0}],
     "decomposition": ["A < B -> C"],
     "interpretation": ["C"]}}]})",
     {},
     {"3:26: /organisms/0/grammar/rules/0: column 1: the limit is 0; it must be 1 or more, or left out; in "
      "`F -> FF`",
      "4:24: /organisms/0/grammar/decomposition/0: column 1: a decomposition rule has no context; remove `<` "
      "and `>`; in `A < B -> C`",
      "5:25: /organisms/0/grammar/interpretation/0: column 2: no arrow; a rule is `predecessor -> "
      "successor`; in `C`"}},
    {"Grammar numbers out of range",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"width": 0,
     "symbols": ["a b"],
     "ignore": "+", "consider": "F"}}]})",
     {},
     {"3:25: /organisms/0/grammar/width: `width` is 0; it must be more than 0",
      "4:17: /organisms/0/grammar/symbols: `a b` cannot be a symbol: no blanks, commas or brackets",
      "5:33: /organisms/0/grammar/consider: give either `ignore` or `consider`, not both"}},
    {"A grammar of the defaults once",
     R"({"defaults": {"form": "own",
  "grammar": {"axiom": "F["}},
 "organisms": [{"kind": "coral"}, {"kind": "coral"}]})",
     {},
     {"2:24: /organisms/0/grammar/axiom: column 2: this `[` is not closed; add a `]`; in `F[`"}},
    {"Rules that no coral grows by, and a coral without its own",
     R"({"organisms": [
  {"kind": "coral", "grammar": {"rules": ["F -> FF"]}},
  {"kind": "coral", "form": "own"}]})",
     {},
     {R"(2:32: /organisms/0/grammar: found rules, but the coral grows by those of its form; expected "form": "own")",
      R"(3:29: /organisms/1/form: found "own" and no rules; expected a "grammar")"}},
    {"Words past their limits",
     R"({"organisms": [
  {"kind": "coral", "form": "own", "grammar": {"rules": ["F -> FF"], "steps": 60}},
  {"kind": "plant", "grammar": {"rules": ["F -> FF"], "steps": 5, "limits": {"modules": 20}}}]})",
     {},
     {"2:47: /organisms/0/grammar: step 28 would have 268 million modules or segments, past the limit of "
      "200000000 "
      "modules and 4294967296 bytes; the last step would have 10^18 (1.15 EB): use at most 27 "
      "steps, or "
      "raise `limits`",
      "3:32: /organisms/1/grammar: step 5 would have 32 modules or segments, past the limit of 20 modules "
      "and "
      "4294967296 bytes; the last step would have 32 (32 bytes): use at most 4 steps, or raise `limits`"}},
    {"A decomposition without end",
     R"({"organisms": [{"kind": "plant", "grammar": {
  "decomposition": ["F -> FX"]}}]})",
     {},
     {"2:21: /organisms/0/grammar/decomposition/0: column 1: `F -> FX` never ends: what it makes is taken "
      "apart into "
      "`F` again; "
      "give it a condition, or put it among `rules`"}},
};

TEST(WrongPresets, Grammars) { expect_messages(kWrongGrammars); }

}  // namespace
}  // namespace frond
