#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/rendering.h"
#include "cli/terminal_events.h"
#include "core/files.h"
#include "core/parallel.h"
#include "pipeline/write_film.h"
#include "render/process.h"

// From a preset to the folder of a film: generate.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// What says to `frond resolve` in the folder of the film what it is of.
std::vector<std::string> resolve_words(PresetArguments preset, const fs::path& out) {
  preset.path = path_from(out, preset.path).string();
  if (preset.assets) preset.assets = path_from(out, *preset.assets).string();
  std::vector<std::string> words;
  add_words(words, preset);
  words.insert(words.end(), {"--film=.", "--quiet"});  // ninja would show what is told only afterwards
  return words;
}

}  // namespace

void generate(const GenerateArguments& arguments) {
  limit_threads(arguments.threads);
  TerminalEvents events(arguments.quiet);
  events.doing("reading the preset");
  PresetArguments asked = arguments.preset;
  fs::path out = out_folder(arguments.out, asked);
  Preset preset = or_fail(load_preset(asked), kWrongInput);
  auto again = [&](const std::vector<std::string>& sets) {
    PresetArguments more = asked;
    more.sets.insert(more.sets.end(), sets.begin(), sets.end());
    return load_preset(more);
  };
  std::vector<Manifest::Budget> budgets = or_fail(count_budgets(preset, again, out, events), kWrongInput);
  for (const Manifest::Budget& budget : budgets) asked.sets.push_back(set_of(budget));
  or_fail(refuse_resolving(preset.film, arguments.resolve), kWrongInput);
  preset.film.raw = is_resolved(preset.film, arguments.resolve);
  FrameRange range =
      or_fail(read_frames(arguments.frames, preset.film.frames, {1, preset.film.frames}), kWrongInput);
  FilmFolder film{preset,
                  asked.path,
                  range,
                  or_fail(home(), kCouldNot),
                  out,
                  own_program(),
                  resolve_words(asked, out),
                  std::move(budgets),
                  arguments.alone};
  Outcome written = arguments.film_only ? write_film_only(film, events) : write_film(film, events);
  if (written.well()) return;
  fail(written.errors, written.of_the_preset ? kWrongInput : kCouldNot);
}

}  // namespace frond
