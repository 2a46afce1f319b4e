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

int generate(GenerateArguments arguments) {
  limit_threads(arguments.threads);
  TerminalEvents events(arguments.quiet);
  events.doing("reading the preset");
  fs::path file = arguments.preset.path;
  fs::path out = arguments.out.empty() ? fs::path("out") / file.stem() : fs::path(arguments.out);
  Result<Preset> preset = load_preset(arguments.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  auto again = [&](const std::vector<std::string>& sets) {
    PresetArguments more = arguments.preset;
    more.sets.insert(more.sets.end(), sets.begin(), sets.end());
    return load_preset(more);
  };
  Result<std::vector<Manifest::Budget>> budgets = count_budgets(*preset, again, out, events);
  if (!budgets) return fail(budgets.errors(), kWrongInput);
  for (const Manifest::Budget& budget : *budgets) arguments.preset.sets.push_back(set_of(budget));
  if (Errors errors = refuse_resolving(preset->film, arguments.resolve); !errors.empty())
    return fail(errors, kWrongInput);
  preset->film.raw = is_resolved(preset->film, arguments.resolve);
  Result<FrameRange> range = read_frames(arguments.frames, preset->film.frames, {1, preset->film.frames});
  if (!range) return fail(range.errors(), kWrongInput);
  Result<fs::path> root = home();
  if (!root) return fail(root.errors(), kCouldNot);
  FilmFolder film{*preset,
                  file,
                  *range,
                  *root,
                  out,
                  own_program(),
                  resolve_words(arguments.preset, out),
                  std::move(*budgets),
                  arguments.alone};
  Outcome written = arguments.film_only ? write_film_only(film, events) : write_film(film, events);
  if (written.well()) return kDone;
  return fail(written.errors, written.of_the_preset ? kWrongInput : kCouldNot);
}

}  // namespace frond
