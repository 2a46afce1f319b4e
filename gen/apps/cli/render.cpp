#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>

#include "cli/bar.h"
#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/judge.h"
#include "cli/messages.h"
#include "cli/out_folder.h"
#include "cli/pace.h"
#include "cli/render_notes.h"
#include "cli/render_run.h"
#include "cli/rendering.h"
#include "cli/streams.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "jobs/jobs.h"
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
    return fmt::format("--format needs mp4, webm, gif or mov, not '{}'", a.format);
  if (a.plot && !a.plot->ends_with(".svg"))
    return fmt::format("--plot needs a name that ends in .svg, not '{}'", *a.plot);
  return {};
}

/// Holds the folder of a run as long as it lives; other runs wait. What this process starts holds it, too, so
/// that a run whose parent was killed is over before the next begins.
class RunLock {
 public:
  explicit RunLock(const fs::path& out) {
    std::error_code error;
    fs::create_directories(out, error);
    if (error) {
      errors_ = {{"", out.string() + ": the folder cannot be made"}};
      return;
    }
    fs::path path = out / ".lock";
    errors_ = refuse_link(path);
    if (!errors_.empty()) return;
    file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW, 0666);
    if (file_ < 0) {
      errors_ = {{"", out.string() + ": cannot be written to"}};
      return;
    }
    if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
    say(fmt::format("Another run is at work in {}; waiting for it", out.string()));
    while (::flock(file_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  ~RunLock() {
    if (file_ >= 0) ::close(file_);
  }
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  const Errors& errors() const { return errors_; }

 private:
  int file_ = -1;
  Errors errors_;
};

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

/// A program that is named by its path has one that holds in any folder.
std::string program_variable(const char* name, const std::string& usual) {
  std::string program = environment_or(name, usual);
  std::error_code error;
  if (program.find('/') != program.npos) program = fs::absolute(program, error).string();
  return fmt::format("{}={}", name, program);
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
  std::string ffmpeg = environment_or("FROND_FFMPEG", "ffmpeg");
  if (preset->film.frames > 1 && a.why == 0 && !find_program(ffmpeg))
    return fail_run({{"", ffmpeg + ": no such program; it is what makes films of frames"}}, kCouldNot);
  return kDone;
}

int render_into(const RenderArguments& a, const fs::path& out) {
  Result<fs::path> root = home();
  if (!root) return fail_run(root.errors(), kCouldNot);
  std::string povray = environment_or("FROND_POVRAY", "povray");
  if (!find_program(povray))
    return fail_run({{"", povray + ": no such program; it is what renders"}}, kCouldNot);
  RunLock lock(out);
  if (!lock.errors().empty()) return fail_run(lock.errors(), kCouldNot);
  StopSignals stop;
  std::string before;
  if (a.why > 0)
    if (Result<std::string> scene = read_file(out / "frames" / (frame_name(a.why) + ".pov")))
      before = std::move(*scene);
  std::error_code error;
  std::string home_folder = fs::absolute(*root, error).string();
  measure_machine(povray);
  if (int code = write_scenes(a, out, home_folder, stop); code != kDone) return code;
  std::vector<std::string> environment{"FROND_HOME=" + home_folder,
                                       program_variable("FROND_POVRAY", "povray"),
                                       program_variable("FROND_FFMPEG", "ffmpeg")};
  if (a.why > 0) return tell_why(Ninja(out, environment, stop), out, a.why, before);
  RenderSettings settings;
  settings.out = out;
  settings.format = a.format;
  settings.every = a.every;
  settings.watch = a.watch;
  settings.jobs = a.jobs > 0 ? a.jobs : thread_count();
  settings.ffmpeg = environment_or("FROND_FFMPEG", "ffmpeg");
  std::size_t noted = read_times(out).size();
  RenderRun run(settings, environment, stop);
  int code = run.run();
  if (code == kInterrupted) return interrupted();
  if (code != kDone) return code;
  note_times(out, noted, run.manifest(), run.rendered(), a.preset.path);
  if (a.plot) {
    if (Errors errors = write_plot(out, run.manifest(), *a.plot); !errors.empty())
      return fail_run(errors, kCouldNot);
    put(fs::absolute(*a.plot, error).lexically_normal().string() + "\n");
  }
  for (const std::string& result : run.results()) put((out / result).string() + "\n");
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
