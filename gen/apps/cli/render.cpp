#include <fmt/format.h>

#include <algorithm>

#include "cli/bar.h"
#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/rendering.h"
#include "cli/streams.h"
#include "cli/terminal_events.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "core/printable.h"
#include "jobs/jobs.h"
#include "pipeline/frame_times.h"
#include "pipeline/out_folder.h"
#include "pipeline/pace.h"
#include "pipeline/render_film.h"
#include "preset/json.h"
#include "render/ninja.h"

// From a preset to a film: render.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// The presets that there are, a line each, with their titles.
void list_presets() {
  fs::path root = or_fail_run(home(), kCouldNot);
  put("Usage: frond render PRESET [options], see frond render --help\n\n");
  for (const fs::path& file : files_below(root / "presets")) {
    fs::path name = file.lexically_relative(root);
    if (file.extension() != ".json" || name.string().starts_with("presets/grammars/")) continue;
    Result<std::string> text = read_file(file);
    Result<Document> document = text ? parse_json(*text, file.string()) : text.errors();
    const Value* title = document ? document->root.find("title") : nullptr;
    put(fmt::format("{:<42} {}\n", name.string(), title ? title->text : ""));
  }
  put("\nA preset of your own to begin with: frond new my_tree --from tree\n");
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

[[noreturn]] void interrupted() {
  say("Interrupted. What is finished is kept: the same command goes on from there.");
  throw CommandEnd{kInterrupted};
}

/// Writes the frames. In a process of its own: what it has grown is no longer in memory while frames are
/// rendered.
void write_scenes(const RenderArguments& a, const fs::path& out, const std::string& root, StopSignals& stop) {
  constexpr int kKilled = 128;
  say("Generating " + out.string());
  Command command;
  command.words = generate_words(a, out);
  command.environment = {"FROND_HOME=" + root};
  command.end_with = SIGTERM;
  pid_t process = or_fail_run(start(command), kCouldNot);
  std::optional<int> status = stop.wait_for(process);
  if (!status) {
    ::kill(process, SIGTERM);
    wait_for(process);
    interrupted();
  }
  if (*status == kDone) return;
  if (*status == kCouldNot || *status == kWrongInput) throw CommandEnd{*status};
  if (*status == kInterrupted || *status == kKilled + SIGTERM) interrupted();
  fail_run({error_at("", "frond ended with exit code {}", *status)}, kCouldNot);
}

/// What of a call of `frond render` does not fit the film of its preset.
Errors judge_render(const RenderArguments& a, const Film& film) {
  if (Errors errors = refuse_resolving(film, a.resolve); !errors.empty()) return errors;
  Result<FrameRange> range = read_frames(a.frames, film.frames, {1, film.frames});
  if (!range) return range.errors();
  if (a.why > 0 && (a.why < range->first || a.why > range->last))
    return {error_at("--why", "{} is no frame of this {}; expected {}-{}", a.why, a.frames ? "run" : "film",
                     range->first, range->last)};
  if (film.transparent() && a.format == "mp4")
    return {{"--format", "an mp4 has no opacity; expected mov, webm, webp or gif"}};
  if (!film.transparent() && a.format == "mov")
    return {{"--format", "a mov is for a transparent film; expected mp4, webm, webp or gif"}};
  return {};
}

/// Whether what is asked for can be made of the preset: before anything is grown. The preset is read for this
/// alone, and is no longer in memory while frames are rendered.
void judge(const RenderArguments& a, const fs::path& out) {
  Preset preset = or_fail(load_preset(a.preset), kWrongInput);
  or_fail_run(judge_render(a, preset.film), kWrongInput);
  or_fail_run(refuse_folder(out), kCouldNot);
  or_fail_run(a.plot ? refuse_file(*a.plot) : Errors{}, kCouldNot);
  or_fail_run(RenderPrograms::usual().missing(preset.film.frames > 1 && a.why == 0), kCouldNot);
}

/// The reason that ninja gives first; the others follow from it. Empty where there is none.
std::string reason_told(const std::string& told, const std::string& name) {
  auto says = [&](const std::string& words) { return told.find(words) != told.npos; };
  std::string scene = name + ".pov", picture = name + ".png", older = "older than most recent input ";
  if (says(scene) && says(" is missing"))
    return "its scene " + scene + " is missing; the next run writes it again";
  if (says(picture + " doesn't exist")) return "there is no picture of it";
  if (says(older + scene)) return "its scene is newer than its picture";
  if (says(older)) {
    std::string rest = told.substr(told.find(older) + older.size());
    return rest.substr(0, rest.find(" (")) + " is newer than its picture";
  }
  if (says("command line changed for " + picture))
    return "its size, quality or flags are others than those it was rendered with";
  if (says("command line not found in log")) return "nothing is noted of how its picture was rendered";
  return says("no work to do") ? "" : told;
}

/// The first line that differs in two texts, as it was and as it is.
void tell_change(const std::string& before, const std::string& now) {
  std::vector<std::string> was = lines_of(before), is = lines_of(now);
  was.resize(std::max(was.size(), is.size()));
  is.resize(was.size());
  auto [a, b] = std::ranges::mismatch(was, is);
  if (a == was.end()) return;
  constexpr std::size_t kMost = 100;
  put(fmt::format("its scene has changed, from line {} on:\n  was: {}\n  is:  {}\n", a - was.begin() + 1,
                  printable(a->substr(0, kMost)), printable(b->substr(0, kMost))));
}

/// Says why the next run in a folder would render a frame, or that it would not; `before` is the text that
/// its scene had, of which the first line that has changed is shown, or empty.
void tell_why(const Ninja& ninja, const fs::path& out, int frame, const std::string& before) {
  std::string name = "frames/" + frame_name(frame);
  std::string told = ninja.answer({"-d", "explain", "-n", name + ".png"});
  if (told.find("unknown target") != told.npos)
    fail_run({error_at("", "frame {} is none of this film", frame)}, kWrongInput);
  std::string reason = reason_told(told, name);
  if (reason.empty()) {
    put(fmt::format("frame {} is up to date\n", frame));
    return;
  }
  put(fmt::format("frame {} is rendered again: {}\n", frame, reason));
  if (Result<std::string> now = read_file(out / (name + ".pov")); now && !before.empty())
    tell_change(before, *now);
}

void render_into(const RenderArguments& a, const fs::path& out) {
  fs::path root = or_fail_run(home(), kCouldNot);
  TerminalEvents events;
  RunLock lock(out, events);
  or_fail_run(lock.errors(), kCouldNot);
  StopSignals stop;
  std::string before;
  if (a.why > 0)
    if (Result<std::string> scene = read_file(out / "frames" / (frame_name(a.why) + ".pov")))
      before = std::move(*scene);
  std::error_code error;
  RenderPrograms programs = RenderPrograms::usual();
  measure_machine(programs.povray);
  write_scenes(a, out, fs::absolute(root, error).string(), stop);
  if (a.why > 0) return tell_why(Ninja(out, programs.environment(root), stop), out, a.why, before);
  RenderSettings settings{.out = out,
                          .format = a.format,
                          .jobs = a.jobs > 0 ? a.jobs : thread_count(),
                          .every = a.every,
                          .watch = a.watch,
                          .ffmpeg = programs.ffmpeg};
  RenderedFilm made = render_written(settings, root, a.preset.path, stop, events);
  end_bar();
  if (made.outcome.stopped) interrupted();
  if (!made.outcome.well()) fail_run(made.outcome.errors, kCouldNot);
  if (a.plot) {
    or_fail_run(write_plot(out, or_fail_run(manifest_in(out), kCouldNot), *a.plot), kCouldNot);
    put(fs::absolute(*a.plot, error).lexically_normal().string() + "\n");
  }
  for (const fs::path& result : made.results) put(result.string() + "\n");
}

}  // namespace

void render(const RenderArguments& arguments) {
  if (const auto& paths = arguments.compare; !paths.empty()) {
    if (paths.size() < 2) fail_run({{"", "--compare: expected A B [FILE]"}}, kWrongInput);
    return compare({paths[0], paths[1], paths.size() > 2 ? std::optional(paths[2]) : std::nullopt, false});
  }
  if (arguments.preset.path.empty()) return list_presets();
  if (std::string wrong = wrong_words(arguments); !wrong.empty()) fail_run({{"", wrong}}, kWrongInput);
  refuse_missing(arguments.preset);
  if (!arguments.sweeps.empty() || arguments.seeds) return sheet(arguments);
  fs::path out = out_folder(arguments.out.empty() ? "" : as_path(arguments.out), arguments.preset);
  judge(arguments, out);
  render_into(arguments, out);
}

}  // namespace frond
