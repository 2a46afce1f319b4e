#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include "cli/bar.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "core/text.h"
#include "farm/farm_folder.h"
#include "farm/farm_plan.h"
#include "jobs/jobs.h"
#include "render/bands.h"
#include "render/local_folder.h"
#include "render/place.h"
#include "render/process.h"

// One task of a film on a farm: task. Frame n is a pure function of the preset, so a task generates what it
// renders, on a disk of its own machine. What is finished is skipped, and a picture comes into the shared
// folder whole or not at all.

namespace frond {

namespace fs = std::filesystem;

namespace {

std::string host() {
  char name[256] = {};
  ::gethostname(name, sizeof name - 1);
  return name;
}

/// Copies a file to its place, whole or not at all; a shared disk may be away for a while.
Errors deliver(const fs::path& file, const fs::path& place) {
  Result<std::string> bytes = read_file(file);
  if (!bytes) return bytes.errors();
  fs::path part =
      place.parent_path() / fmt::format(".{}.{}.{}.part", place.filename().string(), host(), ::getpid());
  for (unsigned wait : {1u, 2u, 4u, 8u, 16u, 0u}) {
    Errors errors = put_text(part, place, *bytes);
    if (errors.empty() || wait == 0 || errors[0].what.ends_with("no room on the disk")) return errors;
    ::sleep(wait);
  }
  return {};
}

/// Notes in the shared folder what was said of what failed; an empty text removes the note.
void note_failure(const fs::path& folder, const std::string& name, const std::string& text) {
  fs::path note = folder / "failed" / name;
  if (text.empty())
    remove_file(note);
  else
    (void)write_file(note, text);
}

/// A picture that a task is to render.
struct Wanted {
  std::string scene, name;         ///< "frame_0001"
  std::vector<std::string> flags;  ///< of POV-Ray, beside those of the film
};

class FarmTask {
 public:
  FarmTask(fs::path folder, int cpus)
      : folder_(std::move(folder)),
        manifest_(manifest_in(folder_)),
        pictures_(folder_ / (manifest_ ? manifest_->drawn_folder() : "frames")),
        cpus_(cpus > 0 ? cpus : thread_count()),
        host_(host()) {}

  void frames(int first, int last, int chunk, int task);
  void band(int bands, int band);
  void film();

 private:
  fs::path picture(const std::string& name) const { return pictures_ / (name + ".png"); }
  [[noreturn]] void fail_here(const std::string& what) const { fail_run({{"", what}}, kCouldNot); }
  int generate(const std::vector<std::string>& options, int err);
  void prepare(const std::string& name, std::vector<std::string> options);
  void bring_models();
  std::size_t render(const std::vector<Wanted>& all);
  Command frame(const Wanted& wanted, int threads, const OutputCapture& said) const;
  bool finished(const Wanted& wanted, int code, const std::string& said);
  void join(int bands, std::array<int, 2> size);

  fs::path folder_;
  Result<Manifest> manifest_;
  fs::path pictures_;  // where those of POV-Ray are brought to
  int cpus_;
  std::string host_, size_, flags_;
  StopSignals stop_;
  LocalFolder local_;
};

/// Calls `frond generate` as the film was asked for.
int FarmTask::generate(const std::vector<std::string>& options, int err) {
  FarmCall call = or_fail_run(read_farm_call(folder_), kCouldNot);
  Command command = generate_command(folder_, call, local_.path(), options);
  command.err = err;
  pid_t process = or_fail_run(start(command), kCouldNot);
  std::optional<int> code = stop_.wait_for(process);
  if (code) return *code;
  ::kill(process, SIGTERM);
  wait_for(process);
  return kStopped;
}

/// Generates in the task's own folder.
void FarmTask::prepare(const std::string& name, std::vector<std::string> options) {
  if (local_.path().empty())
    fail_here(fmt::format("{}: no folder can be made there on {}", local_.near().string(), host_));
  std::error_code error;
  fs::create_directories(local_.path() / "frames", error);
  for (const fs::path& file : files_in(folder_ / "models"))
    if (!file.filename().string().starts_with('.'))
      fs::copy_file(file, local_.path() / "frames" / file.filename(), error);
  OutputCapture said;
  options.push_back(fmt::format("--threads={}", cpus_));
  int code = generate(options, said.descriptor());
  for (const std::string& line : lines_of(said.text())) say(line);
  if (code != kDone) {
    if (code != kStopped) note_failure(folder_, name, said.text());
    throw CommandEnd{code};
  }
  note_failure(folder_, name, "");
  bring_models();
  std::string ninja = or_fail_run(read_file(local_.path() / "build.ninja"), kCouldNot);
  size_ = ninja_variable(ninja, "size");
  flags_ = ninja_variable(ninja, "flags");
}

/// Files beside frames bear the name of what is in them: what one task has grown serves all, and only one
/// brings it.
void FarmTask::bring_models() {
  for (const fs::path& file : files_in(local_.path() / "frames")) {
    std::string name = file.filename();
    fs::path place = folder_ / "models" / name, claim = folder_ / "models" / ("." + name + ".claim");
    if (name.starts_with("frame_") || path_exists(place)) continue;
    std::FILE* claimed = std::fopen(claim.c_str(), "wxe");
    if (!claimed) continue;
    std::fclose(claimed);
    tell_failure(deliver(file, place));
  }
}

Command FarmTask::frame(const Wanted& wanted, int threads, const OutputCapture& said) const {
  Command command;
  command.words = {own_program().string(),           "frame", "frames/" + wanted.scene + ".pov",
                   "frames/" + wanted.name + ".png", size_,   "--"};
  command.add(split(flags_, ' '));
  command.add(wanted.flags);
  command.environment = {fmt::format("FROND_THREADS={}", threads)};
  command.folder = local_.path();
  command.err = said.descriptor();
  command.end_with = SIGTERM;
  return command;
}

/// Brings a picture into the shared folder. What is said of one that fails is kept there, too.
bool FarmTask::finished(const Wanted& wanted, int code, const std::string& said) {
  for (const std::string& line : lines_of(said)) say(line);
  if (code != kDone) {
    note_failure(folder_, wanted.name, said);
    return false;
  }
  fs::path made = local_.path() / "frames" / (wanted.name + ".png");
  if (Errors errors = deliver(made, picture(wanted.name)); !errors.empty()) {
    tell_failure(errors);
    return false;
  }
  remove_file(made);
  note_failure(folder_, wanted.name, "");
  say(fmt::format("{}.png is done, on {}", wanted.name, host_));
  return true;
}

/// Renders pictures, as many at once as there are processors; how many could not be.
std::size_t FarmTask::render(const std::vector<Wanted>& all) {
  struct Running {
    const Wanted* wanted = nullptr;
    std::unique_ptr<OutputCapture> said;
  };
  std::map<pid_t, Running> running;
  int threads = std::max(1, cpus_ / static_cast<int>(all.size()));
  std::size_t failed = 0, next = 0;
  bool stopped = false;
  while (!stopped && (next < all.size() || !running.empty())) {
    if (next < all.size() && static_cast<int>(running.size()) < cpus_) {
      auto said = std::make_unique<OutputCapture>();
      Result<pid_t> process = start(frame(all[next], threads, *said));
      if (process)
        running[*process] = {&all[next], std::move(said)};
      else
        tell_failure(process.errors()), ++failed;
      ++next;
      continue;
    }
    std::optional<StopSignals::Ended> ended = stop_.wait_for_any();
    stopped = !ended;
    auto at = ended ? running.find(ended->process) : running.end();
    if (at == running.end()) continue;
    if (!finished(*at->second.wanted, ended->code, at->second.said->text())) ++failed;
    running.erase(at);
  }
  for (const auto& [process, frame] : running) ::kill(process, SIGTERM);
  for (const auto& [process, frame] : running) wait_for(process);
  if (stopped) throw CommandEnd{kStopped};
  return failed;
}

void FarmTask::frames(int first, int last, int chunk, int task) {
  int from = first + (task - 1) * chunk, to = std::min(from + chunk - 1, last);
  std::vector<Wanted> missing;
  std::vector<int> numbers;
  for (int number = from; number <= to; ++number) {
    if (whole_picture(picture(frame_name(number)))) continue;
    missing.push_back({frame_name(number), frame_name(number), {}});
    numbers.push_back(number);
  }
  if (missing.empty()) {
    say(fmt::format("Frames {} to {} are done already", from, to));
    return;
  }
  prepare(fmt::format("frames_{}-{}", from, to),
          {"--alone", fmt::format("--frames={}-{}", numbers.front(), numbers.back())});
  if (std::size_t failed = render(missing))
    fail_here(fmt::format("{} of {} frames could not be rendered on {}", failed, missing.size(), host_));
}

void FarmTask::band(int bands, int band) {
  std::string name = band_name(band, bands);
  if (whole_picture(picture(name))) {
    say(fmt::format("Band {} is done already", band));
    return;
  }
  prepare(name, {});
  BandRows rows = band_rows(bands, band, size_of(size_)[1]);
  std::size_t failed =
      render({{frame_name(1), name, {fmt::format("+SR{}", rows.top + 1), fmt::format("+ER{}", rows.below)}}});
  if (failed > 0) fail_here(fmt::format("band {} could not be rendered on {}", band, host_));
}

/// Joins the bands of a still. Those that are damaged go, so that they are rendered again.
void FarmTask::join(int bands, std::array<int, 2> size) {
  std::vector<std::string> pngs;
  bool damaged = false;
  for (int band = 1; band <= bands; ++band) {
    fs::path file = picture(band_name(band, bands));
    if (!path_exists(file))
      fail_here(fmt::format("band {} of {} is missing; the same call of farm.sh renders it", band, bands));
    Result<std::string> png = whole_picture(file, size);
    if (png) {
      pngs.push_back(std::move(*png));
      continue;
    }
    say(fmt::format("frames/{} is damaged; the same call of farm.sh makes it again",
                    file.filename().string()));
    remove_file(file);
    damaged = true;
  }
  if (damaged) fail_here("the bands could not be joined");
  Result<std::string> whole = join_bands(pngs);
  if (!whole) fail_here("the bands could not be joined: " + whole.errors()[0].what);
  fs::path still = picture(frame_name(1));
  or_fail_run(put_text(part_of(still), still, *whole), kCouldNot);
}

void FarmTask::film() {
  const Manifest manifest = or_fail_run(manifest_, kCouldNot);
  std::vector<std::string> results{film_file(film_format(manifest.transparent)), "contact.png"};
  if (manifest.still) {
    results = {"still.png"};
    int bands = bands_of(folder_);
    if (bands > 0 && !path_exists(picture(frame_name(1)))) join(bands, manifest.size);
  }
  std::vector<int> lost;
  auto [first, last] = manifest.drawn();
  for (int frame = first; frame <= last; ++frame)
    if (!whole_picture(picture(frame_name(frame)))) lost.push_back(frame);
  if (!lost.empty())
    fail_here(
        fmt::format("frames {} are missing; the same call of farm.sh renders them", fmt::join(lost, " ")));
  Command command;
  command.words = {"ninja"};
  command.environment = {"NINJA_STATUS=", "FROND_HOME=" + (folder_ / "tool").string()};
  command.folder = folder_;
  command.out = 2;
  command.end_with = SIGTERM;
  Result<pid_t> process = start(command);
  std::optional<int> code = process ? stop_.wait_for(*process) : 1;
  if (!code) throw CommandEnd{kStopped};
  if (*code != 0) fail_here(folder_.string() + ": the film could not be made; its frames are kept");
  for (const std::string& result : results)
    or_fail_run(deliver(folder_ / result, folder_.parent_path().parent_path() / result), kCouldNot);
  for (const char* inside : {"frames", "models"})
    for (const fs::path& file : files_in(folder_ / inside))
      if (file.filename().string().starts_with('.') &&
          (file.extension() == ".part" || file.extension() == ".claim"))
        remove_file(file);
  say(fmt::format("{}: done, on {}", fmt::join(results, " "), host_));
}

/// Whole numbers from 1 on; empty where one of the words is none.
std::vector<int> numbers_of(const std::vector<std::string>& words) {
  std::vector<int> numbers;
  for (const std::string& word : words) {
    int number = counting_number(word);
    if (number == 0) return {};
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

void farm_task(const TaskArguments& arguments) {
  std::error_code error;
  FarmTask task(fs::absolute(arguments.folder, error), arguments.cpus);
  if (arguments.work == "film") return task.film();
  std::vector<std::string> words = arguments.words;
  std::size_t wanted = arguments.work == "frames" ? 4 : 2;  // the last is the task
  if (words.size() + 1 == wanted) words.push_back(environment_or("SLURM_ARRAY_TASK_ID", ""));
  std::vector<int> numbers = numbers_of(words);
  if (numbers.size() == wanted && arguments.work == "frames")
    return task.frames(numbers[0], numbers[1], numbers[2], numbers[3]);
  if (numbers.size() == wanted && arguments.work == "bands") return task.band(numbers[0], numbers[1]);
  fail_run({{"", "expected frames FIRST LAST CHUNK [TASK], bands N [TASK] or film"}}, kWrongInput);
}

}  // namespace frond
