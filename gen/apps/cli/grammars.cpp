#include <fmt/format.h>

#include <cmath>

#include "cli/commands.h"
#include "cli/cpfg_models.h"
#include "cli/inputs.h"
#include "cli/streams.h"
#include "core/files.h"
#include "cpfg/cpfg.h"
#include "grammar/figure.h"
#include "grammar/forecast.h"
#include "grammar/kind.h"
#include "grammar/picture.h"
#include "grammar/review.h"
#include "organisms/grammar_file.h"

namespace frond {

namespace {

/// A compiled grammar with the steps and the seed that the command line asks for.
struct Loaded {
  Grammar grammar;
  double steps;
  Seed seed;
};

/// The grammar of a file: a grammar itself, or that of a preset's plan or of its first organism that has one.
Result<Grammar> load_grammar(const std::string& path, const std::optional<std::string>& assets,
                             std::string_view system) {
  Result<std::string> text = read_file(path);
  if (text && !system.empty() && grammar_kind(path, *text) != GrammarKind::fractint)
    return Error{"--system", "only files of Fractint hold several systems; expected none here"};
  if (is_grammar(path)) {
    if (!text) return text.errors();
    Result<Assets> files = assets_of(path, assets);
    if (!files) return files.errors();
    Result<GrammarText> file = read_grammar(*text, path, *files, system);
    if (!file) return file.errors();
    return compile(*file);
  }
  PresetArguments named;
  named.path = path;
  named.assets = assets;
  Result<Preset> preset = load_preset(named);
  if (!preset) return preset.errors();
  tell_notes(preset->notes);
  if (preset->plan) return compile_plan(*preset->plan);
  for (const Organism& organism : preset->organisms)
    if (auto grammar = organism.grower->grammar()) return *grammar;
  return Error{path, "the preset has no organism that grows by a grammar"};
}

/// Says why a derivation came to no end.
[[noreturn]] void fail_derivation(const Errors& errors, const Grammar& grammar, const std::string& path) {
  fail(in_file(placed(errors, grammar.text), path), kWrongInput);
}

/// The grammar with what the command line says about its rules and angle.
Result<Grammar> changed(const Grammar& grammar, const GrammarArguments& arguments) {
  GrammarText text = grammar.text;
  text.angle = arguments.angle.value_or(text.angle);
  text.mutations += arguments.mutations;
  if (arguments.mutations > 0 && arguments.seed) text.seed = *arguments.seed;
  if (arguments.mutations > 0 && text.dialect != Dialect::lparser)
    return Error{"--mutate", "only grammars of LParser are mutated"};
  return compile(text);
}

Loaded load(const GrammarArguments& arguments) {
  Result<Grammar> grammar = load_grammar(arguments.path, arguments.assets, arguments.system);
  if (grammar && (arguments.angle || arguments.mutations > 0)) grammar = changed(*grammar, arguments);
  if (!grammar) fail(in_file(grammar.errors(), arguments.path), kWrongInput);
  // Those of a preset have been told with it.
  if (is_grammar(arguments.path)) tell_notes(in_file(grammar->warnings, arguments.path));
  double steps = arguments.steps.value_or(grammar->text.growth());
  if (std::isnan(steps)) fail({{"--steps", "found nan; expected a number of 0 or more"}}, kWrongInput);
  Seed seed{arguments.seed.value_or(grammar->text.seed)};
  return {std::move(*grammar), steps, seed};
}

/// Writes a picture, if one was asked for.
void write_picture(const GrammarArguments& arguments, const Grammar& grammar,
                   const Result<std::string>& svg) {
  if (!svg) fail_derivation(svg.errors(), grammar, arguments.path);
  or_fail(write_file(*arguments.picture, *svg), kCouldNot);
}

std::string list(DVec3 v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

}  // namespace

void info_grammar(const std::string& path, const std::optional<std::string>& assets, bool json) {
  GrammarArguments arguments;
  arguments.path = path, arguments.assets = assets;
  if (is_cpfg_model(path)) return info_cpfg(arguments, json);
  const auto [grammar, steps, seed] = load(arguments);
  Forecast size = forecast(grammar, static_cast<int>(std::ceil(steps)), seed, grammar.text.limits);
  constexpr const char* kKinds[] = {"exact", "expected", "extrapolated", "at least"};
  std::string_view form =
      json ? "{{\"forecast\": \"{}\", \"steps\": {}, \"modules\": {:.15g}, \"segments\": {:.15g}, "
             "\"bytes\": {:.15g}}}\n"
           : "{}: after {} steps {:.15g} modules, {:.15g} segments, {:.15g} bytes\n";
  put(fmt::format(fmt::runtime(form), kKinds[static_cast<int>(size.kind)], steps, size.modules, size.segments,
                  size.bytes));
  if (Errors errors = refuse(size, grammar.text.limits); !errors.empty())
    fail_derivation(errors, grammar, path);
}

void check_grammar(const PresetArguments& arguments) {
  const std::string& path = arguments.path;
  if (!arguments.sets.empty())
    fail({{path, "is a grammar, of which --set sets nothing; expected a preset"}}, kWrongInput);
  if (is_cpfg_model(path)) {
    CpfgModel model = or_fail(read_cpfg(path), kWrongInput);
    for (const std::string& note : model.notes) tell("note: " + note);
  } else {
    Result<Grammar> grammar = load_grammar(path, arguments.assets, {});
    if (!grammar) fail(in_file(grammar.errors(), path), kWrongInput);
    tell_notes(in_file(grammar->warnings, path));
  }
  tell(fmt::format(
      "{0}: a grammar, no preset, and without a fault; `frond turtle {0} --svg FILE.svg` draws it, "
      "`frond derive {0}` derives it, `frond import {0}` writes a preset of one of another program",
      path));
}

void derive_word(const GrammarArguments& arguments) {
  if (is_cpfg_model(arguments.path)) return derive_cpfg(arguments);
  const auto [grammar, exact, seed] = load(arguments);
  now_doing("deriving the word");
  auto steps = static_cast<int>(std::ceil(exact));
  if (arguments.picture) return write_picture(arguments, grammar, derivation_tree_svg(grammar, steps, seed));
  Result<Word> word = derive(grammar, steps, seed, grammar.text.limits);
  if (!word) fail_derivation(word.errors(), grammar, arguments.path);
  if (arguments.format == "counts") {
    for (const auto& [name, count] : counts(grammar, *word)) put(fmt::format("{} {}\n", name, count));
  } else {
    put(text(grammar, *word));
    put("\n");
  }
}

void walk_turtle(const GrammarArguments& arguments) {
  if (is_cpfg_model(arguments.path)) return turtle_cpfg(arguments);
  const auto [grammar, steps, seed] = load(arguments);
  const Limits& limits = grammar.text.limits;
  now_doing("deriving the word and walking along it");
  Forecast size = forecast(grammar, static_cast<int>(std::ceil(steps)), seed, limits);
  if (Errors errors = refuse(size, limits); !errors.empty()) fail_derivation(errors, grammar, arguments.path);
  if (arguments.picture) return write_picture(arguments, grammar, turtle_svg(grammar, steps, seed, limits));
  Result<TurtleStats> stats = stats_of(grammar, steps, seed, limits);
  if (!stats) fail_derivation(stats.errors(), grammar, arguments.path);
  std::string ends;
  for (DVec3 end : stats->end_positions) ends += (ends.empty() ? "" : ", ") + list(end);
  put(fmt::format(
      "{{\"segments\": {}, \"total_length\": {}, \"end_position\": {}, \"end_heading\": {}, \"end_left\": "
      "{}, \"end_up\": {}, \"bbox\": [{}, {}], \"max_stack_depth\": {}, \"polygons\": {}, "
      "\"turtles_at_end\": {}, \"end_positions\": [{}]}}\n",
      stats->segments, stats->total_length, list(stats->end_position), list(stats->end_heading),
      list(stats->end_left), list(stats->end_up), list(stats->low), list(stats->high), stats->max_stack_depth,
      stats->polygons, stats->end_positions.size(), ends));
}

}  // namespace frond
