#include <fmt/format.h>

#include <algorithm>

#include "cli/bar.h"
#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/judge.h"
#include "cli/messages.h"
#include "cli/render_why.h"
#include "cli/rendering.h"
#include "cli/streams.h"
#include "cli/terminal_events.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "jobs/jobs.h"
#include "pipeline/frame_times.h"
#include "pipeline/out_folder.h"
#include "pipeline/pace.h"
#include "pipeline/render_film.h"
#include "preset/json.h"
#include "render/place.h"

// From a preset to a film: render.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// The presets that there are, a line each, with their titles.
int list_presets() {
  Result<fs::path> root = home();
  if (!root) return fail_run(root.errors(), kCouldNot);
  put("Usage: frond render PRESET [options], see frond render --help\n\n");
  for (const fs::path& file : files_below(*root / "presets")) {
    fs::path name = file.lexically_relative(*root);
    if (file.extension() != ".json" || name.string().starts_with("presets/grammars/")) continue;
    Result<std::string> text = read_file(file);
    Result<Document> document = text ? parse_json(*text, file.string()) : text.errors();
    const Value* title = document ? document->root.find("title") : nullptr;
    put(fmt::format("{:<42} {}\n", name.string(), title ? title->text : ""));
  }
  put("\nA preset of your own to begin with: frond new my_tree --from tree\n");
  return kDone;
}

/// What is wrong with the words of a call; empty where nothing is.
std::string wrong_words(const RenderArguments& a) {
  if (!a.format.empty() && std::ranges::find(kFilmFormats, a.format) == std::end(kFilmFormats))
    return fmt::format("--format needs mp4, webm, gif, webp or mov, not '{}'", a.format);
  if (a.plot && !a.plot->ends_with(".svg"))
    return fmt::format("--plot needs a name that ends in .svg, not '{}'", *a.plot);
  return {};
}

/// The words that have a program write the frames.
std::vector<std::string> generate_words(const RenderArguments& a, const fs::path& out) {
  std::vector<std::string> words{environment_or("FROND_BIN", own_program().string()), "generate"};
  add_words(words, a.preset);
  words.push_back("--out=" + out.string());
  if (a.frames) words.push_back("--frames=" + *a.frames);
  if (a.resolve) words.push_back(*a.resolve ? "--resolve" : "--no-resolve");
  if (a.threads > 0) words.push_back(fmt::format("--threads={}", a.threads));
  return words;
}

int interrupted() {
  say("Interrupted. What is finished is kept: the same command goes on from there.");
  return kInterrupted;
}

/// Writes the frames. In a process of its own: what it has grown is no longer in memory while frames are
/// rendered.
int write_scenes(const RenderArguments& a, const fs::path& out, const std::string& root, StopSignals& stop) {
  constexpr int kKilled = 128;
  say("Generating " + out.string());
  Command command;
  command.words = generate_words(a, out);
  command.environment = {"FROND_HOME=" + root};
  command.end_with = SIGTERM;
  Result<pid_t> process = start(command);
  if (!process) return fail_run(process.errors(), kCouldNot);
  std::optional<int> status = stop.wait_for(*process);
  if (!status) {
    ::kill(*process, SIGTERM);
    wait_for(*process);
    return interrupted();
  }
  if (*status == kDone || *status == kCouldNot || *status == kWrongInput) return *status;
  if (*status == kInterrupted || *status == kKilled + SIGTERM) return interrupted();
  return fail_run({{"", fmt::format("frond ended with exit code {}", *status)}}, kCouldNot);
}

/// Whether what is asked for can be made of the preset: before anything is grown. The preset is read for this
/// alone, and is no longer in memory while frames are rendered.
int judge(const RenderArguments& a, const fs::path& out) {
  Result<Preset> preset = load_preset(a.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  if (Errors errors = judge_render(a, preset->film); !errors.empty()) return fail_run(errors, kWrongInput);
  if (Errors errors = refuse_folder(out); !errors.empty()) return fail_run(errors, kCouldNot);
  if (Errors errors = a.plot ? refuse_file(*a.plot) : Errors{}; !errors.empty())
    return fail_run(errors, kCouldNot);
  Errors errors = RenderPrograms::usual().missing(preset->film.frames > 1 && a.why == 0);
  return errors.empty() ? int{kDone} : fail_run(errors, kCouldNot);
}

int render_into(const RenderArguments& a, const fs::path& out) {
  Result<fs::path> root = home();
  if (!root) return fail_run(root.errors(), kCouldNot);
  TerminalEvents events;
  RunLock lock(out, events);
  if (!lock.errors().empty()) return fail_run(lock.errors(), kCouldNot);
  StopSignals stop;
  std::string before;
  if (a.why > 0)
    if (Result<std::string> scene = read_file(out / "frames" / (frame_name(a.why) + ".pov")))
      before = std::move(*scene);
  std::error_code error;
  RenderPrograms programs = RenderPrograms::usual();
  measure_machine(programs.povray);
  if (int code = write_scenes(a, out, fs::absolute(*root, error).string(), stop); code != kDone) return code;
  if (a.why > 0) return tell_why(Ninja(out, programs.environment(*root), stop), out, a.why, before);
  RenderSettings settings{.out = out,
                          .format = a.format,
                          .jobs = a.jobs > 0 ? a.jobs : thread_count(),
                          .every = a.every,
                          .watch = a.watch,
                          .ffmpeg = programs.ffmpeg};
  RenderedFilm made = render_written(settings, *root, a.preset.path, stop, events);
  end_bar();
  if (made.outcome.stopped) return interrupted();
  if (!made.outcome.well()) return fail_run(made.outcome.errors, kCouldNot);
  if (a.plot) {
    Result<Manifest> manifest = manifest_in(out);
    Errors errors = manifest ? write_plot(out, *manifest, *a.plot) : manifest.errors();
    if (!errors.empty()) return fail_run(errors, kCouldNot);
    put(fs::absolute(*a.plot, error).lexically_normal().string() + "\n");
  }
  for (const fs::path& result : made.results) put(result.string() + "\n");
  return kDone;
}

}  // namespace

int render(const RenderArguments& arguments) {
  if (const auto& paths = arguments.compare; !paths.empty()) {
    if (paths.size() < 2) return fail_run({{"", "--compare: expected A B [FILE]"}}, kWrongInput);
    return compare({paths[0], paths[1], paths.size() > 2 ? std::optional(paths[2]) : std::nullopt, false});
  }
  if (arguments.preset.path.empty()) return list_presets();
  if (std::string wrong = wrong_words(arguments); !wrong.empty()) return fail_run({{"", wrong}}, kWrongInput);
  std::error_code error;
  const std::string& preset = arguments.preset.path;
  if (!fs::is_regular_file(preset, error))
    return fail_run({{"", preset + ": no such preset" + nearest_presets(preset)}}, kWrongInput);
  if (!arguments.sweeps.empty() || arguments.seeds) return sheet(arguments);
  fs::path out =
      arguments.out.empty() ? fs::path("out") / fs::path(preset).stem() : fs::path(as_path(arguments.out));
  if (int code = judge(arguments, out); code != kDone) return code;
  return render_into(arguments, out);
}

}  // namespace frond
