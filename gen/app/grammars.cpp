#include <fmt/format.h>

#include "app/commands.h"
#include "app/inputs.h"
#include "core/files.h"
#include "core/text.h"
#include "grammar/figure.h"
#include "preset/json.h"
#include "preset/reader.h"
#include "scene/describe.h"

namespace frond {

namespace {

/// A word that was derived, and the grammar it is a word of.
struct Derived {
  Grammar grammar;
  Word word;
  Seed seed;
};

/// The grammar of a file: a grammar itself, or that of the first organism of a preset that has one.
Result<Grammar> load_grammar(const std::string& path) {
  Result<std::string> text = read_file(path);
  if (!text) return text.errors();
  Result<Document> document = parse_json(*text, path);
  if (!document) return document.errors();
  if (!document->root.find("organisms")) {
    Result<GrammarText> grammar = read_preset<GrammarText>(*document);
    if (!grammar) return grammar.errors();
    return compile(*grammar);
  }
  Result<Preset> preset = read_preset(*text, path, {});
  if (!preset) return preset.errors();
  for (const Organism& organism : preset->organisms) {
    if (const auto* coral = std::get_if<CoralParams>(&organism.body)) return coral_grammar(*coral);
    if (const auto* plant = std::get_if<PlantParams>(&organism.body)) return plant_grammar(*plant);
  }
  return Error{path, "the preset has no organism that grows by a grammar"};
}

Result<Derived> derive_file(const std::string& path, std::optional<int> steps,
                            std::optional<std::uint64_t> seed) {
  Result<Grammar> grammar = load_grammar(path);
  if (!grammar) return grammar.errors();
  for (const Error& warning : grammar->warnings)
    fmt::print(stderr, "{}: warning: {}\n", path, warning.text());
  Seed random{seed.value_or(grammar->text.seed)};
  Result<Word> word = derive(*grammar, steps.value_or(grammar->text.steps), random);
  if (!word) return word.errors();
  return Derived{std::move(*grammar), std::move(*word), random};
}

std::string list(DVec3 v) {
  std::string text = "[";
  append_list(text, 9, v.x, v.y, v.z);
  return text + "]";
}

}  // namespace

int derive_word(const std::string& path, std::optional<int> steps, std::optional<std::uint64_t> seed,
                bool as_counts) {
  Result<Derived> derived = derive_file(path, steps, seed);
  if (!derived) return fail(derived.errors(), kWrongInput);
  if (as_counts) {
    for (const auto& [name, count] : counts(derived->grammar, derived->word))
      fmt::print("{} {}\n", name, count);
  } else {
    fmt::print("{}\n", text(derived->grammar, derived->word));
  }
  return kDone;
}

int walk_turtle(const std::string& path, std::optional<int> steps, std::optional<std::uint64_t> seed) {
  Result<Derived> derived = derive_file(path, steps, seed);
  if (!derived) return fail(derived.errors(), kWrongInput);
  TurtleStats stats = stats_of(derived->grammar, derived->word, derived->seed.child("turtle"));
  std::string length;
  append(length, stats.total_length, 9);
  fmt::print(
      "{{\"segments\": {}, \"total_length\": {}, \"end_position\": {}, \"end_heading\": {}, \"end_left\": "
      "{}, "
      "\"end_up\": {}, \"bbox\": [{}, {}], \"max_stack_depth\": {}, \"polygons\": {}}}\n",
      stats.segments, length, list(stats.end_position), list(stats.end_heading), list(stats.end_left),
      list(stats.end_up), list(stats.low), list(stats.high), stats.max_stack_depth, stats.polygons);
  return kDone;
}

}  // namespace frond
