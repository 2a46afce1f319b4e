#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cli/bar.h"
#include "cli/commands.h"
#include "cli/farm_folder.h"
#include "cli/farm_hand.h"
#include "cli/farm_plan.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/rendering.h"
#include "cli/streams.h"
#include "core/files.h"
#include "core/printable.h"
#include "core/text.h"
#include "render/process.h"
#include "render/slurm.h"

// A film on many machines: farm. It makes the folder of the job and finds out what is to be done;
// farm_hand.cpp hands that out, and farm_task.cpp is what each task does.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// A number from 1 to 99999; 0 where the text is none.
int count_of(const std::string& text) {
  constexpr int kMost = 99'999;
  int number = text.starts_with('0') ? 0 : counting_number(text);
  return number <= kMost ? number : 0;
}

bool are_hosts(const std::string& text) {
  auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  auto begins = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
  auto goes_on = [&](char c) { return begins(c) || std::string_view("@._:-").find(c) != std::string::npos; };
  std::vector<std::string> names = split(text, ',');
  return !text.empty() && text.back() != ',' && std::ranges::all_of(names, [&](const std::string& name) {
    return !name.empty() && begins(name[0]) && std::ranges::all_of(name, goes_on);
  });
}

/// What is wrong with the words of a call; empty where nothing is.
std::string wrong_farm_words(const FarmArguments& a) {
  for (const auto& [name, given] : {std::pair("--frames", &a.frames), std::pair("--site", &a.site),
                                    std::pair("--partition", &a.partition), std::pair("--hosts", &a.hosts),
                                    std::pair("--openjd", &a.openjd), std::pair("--opencue", &a.opencue)})
    if (*given && (*given)->empty()) return fmt::format("{} needs a value", name);
  for (const auto& [name, given] : {std::pair("--chunk", &a.chunk), std::pair("--bands", &a.bands)})
    if (count_of(*given) == 0) return fmt::format("{} needs a number from 1 on, not '{}'", name, *given);
  if (a.hosts && !are_hosts(*a.hosts))
    return fmt::format("--hosts needs names of machines with commas between them, not '{}'", *a.hosts);
  return {};
}

/// The first lines of what was said of a picture that failed, on one.
std::string first_words_of(const fs::path& note) {
  constexpr std::size_t kLines = 3;
  Result<std::string> text = read_file(note);
  std::string words;
  if (!text) return words;
  std::vector<std::string> lines = lines_of(*text);
  for (std::size_t i = 0; i < std::min(lines.size(), kLines); ++i) words += (i ? " " : "") + lines[i];
  return words;
}

/// Of a state of Slurm, where that is of tasks that are still to come or at work; else empty.
std::string_view word_of(std::string_view state) {
  return state == "RUNNING"      ? "running"
         : state == "PENDING"    ? "pending"
         : state == "COMPLETING" ? "completing"
                                 : "";
}

int show_status(const fs::path& farm) {
  fs::path job = farm / "latest";
  std::string text = farm_status(job);
  std::error_code error;
  if (Result<std::string> jobs = read_file(job / "jobs"); jobs && find_program("squeue"))
    for (const auto& [state, count] : slurm_tasks(jobs_in(*jobs), "all"))
      if (std::string_view word = word_of(state); !word.empty())
        text += fmt::format("{} tasks are {}\n", count, word);
  put(text);
  for (const fs::path& note : files_in(job / "failed"))
    if (fs::is_regular_file(note, error))
      put(printable(fmt::format("{} failed: {}", note.filename().string(), first_words_of(note))) + "\n");
  for (const fs::path& result : results_of(farm))
    if (result.stem() == "film" || result.stem() == "still") put(result.filename().string() + " is there\n");
  return kDone;
}

int end_jobs(const fs::path& farm) {
  if (!find_program("scancel"))
    return fail_run({{"", "scancel: no such program; this machine is no part of a Slurm cluster"}},
                    kCouldNot);
  Result<std::string> jobs = read_file(farm / "latest" / "jobs");
  Errors errors = jobs ? cancel_in_slurm(jobs_in(*jobs)) : Errors{};
  return errors.empty() ? int{kDone} : fail_run(errors, kCouldNot);
}

int show_logs(const fs::path& farm) {
  constexpr std::size_t kLines = 20;
  std::string text;
  std::error_code error;
  for (const fs::path& log : files_below(farm / "latest" / "log")) {
    Result<std::string> said = fs::is_regular_file(log, error) ? read_file(log) : std::string();
    if (!said || said->empty()) continue;
    std::vector<std::string> lines = lines_of(*said);
    text += fmt::format("{}==> {} <==\n", text.empty() ? "" : "\n", log.string());
    for (std::size_t i = lines.size() - std::min(lines.size(), kLines); i < lines.size(); ++i)
      text += lines[i] + '\n';
  }
  put(text);
  return kDone;
}

int look_at(const FarmArguments& a, const fs::path& farm) {
  std::error_code error;
  if (!fs::is_directory(farm / "latest", error))
    return fail_run({{"", farm.string() + ": no film was handed to a farm there"}}, kWrongInput);
  return a.status ? show_status(farm) : a.cancel ? end_jobs(farm) : show_logs(farm);
}

/// What is not there that the film is to be handed to.
int check_queue(const FarmArguments& a, const fs::path& farm) {
  if (a.hosts && !find_program("parallel"))
    return fail_run({{"", "parallel: no such program; --hosts needs GNU parallel: apt-get install parallel"}},
                    kCouldNot);
  if (a.hosts || a.openjd || a.opencue) return kDone;
  if (!find_program("sbatch"))
    return fail_run({{"",
                      "sbatch: no such program; this machine is no part of a Slurm cluster; --hosts and "
                      "--openjd need none"}},
                    kCouldNot);
  if (a.partition && !has_slurm_partition(*a.partition)) {
    Result<std::vector<std::string>> there = slurm_partitions();
    if (!there) return fail_run(there.errors(), kCouldNot);
    std::string names;
    for (const std::string& name : *there) names += " " + name;
    return fail_run({{"", fmt::format("--partition: there is no '{}'; there is{}", *a.partition, names)}},
                    kWrongInput);
  }
  Result<std::string> jobs = read_file(farm / "latest" / "jobs");
  if (jobs && !slurm_tasks(jobs_in(*jobs), "PENDING,RUNNING,COMPLETING").empty())
    return fail_run(
        {{"", farm.string() + ": a farm is at work there; see --status, or end it with --cancel"}},
        kWrongInput);
  return kDone;
}

/// Whether a still is drawn in bands, which are joined as they are.
bool in_bands(const FarmArguments& a, const Film& film) {
  return film.frames == 1 && counting_number(a.bands) > 1;
}

FarmCall call_of(const FarmArguments& a, const Film& film) {
  std::error_code error;
  auto whole = [&](const std::string& path) {
    fs::path from_root = fs::absolute(path, error).lexically_normal();
    return from_root.has_filename() ? from_root : from_root.parent_path();
  };
  FarmCall call{fs::current_path(error), whole(a.preset.path), {}, {}};
  if (a.preset.assets) call.assets = whole(*a.preset.assets);
  PresetArguments rest = a.preset;
  rest.assets.reset();
  add_words(call.options, rest);
  call.options.erase(call.options.begin());  // the preset
  call.options.push_back(!in_bands(a, film) && is_resolved(film, a.resolve) ? "--resolve" : "--no-resolve");
  return call;
}

/// What the tasks find out of the environment, and the modules that they load.
Errors write_surroundings(const fs::path& job, const FarmSite& site) {
  std::string modules, environment;
  for (const std::string& module : site.modules) modules += module + '\n';
  for (const char* name : {"FROND_POVRAY", "FROND_FFMPEG", "FROND_UNCONFINED"})
    if (std::string value = environment_or(name, ""); !value.empty())
      environment += fmt::format("{}={}\n", name, value);
  for (const auto& [name, text] : {std::pair("modules", &modules), std::pair("environment", &environment)})
    if (Result<bool> written = write_file(job / name, *text); !written) return written.errors();
  return {};
}

/// Makes the folder of the job, or finds it.
int make_job(const FarmArguments& a, Handed& to) {
  Result<Preset> preset = load_preset(a.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  if (Errors errors = refuse_resolving(preset->film, a.resolve); !errors.empty())
    return fail(errors, kWrongInput);
  if (preset->film.crop && in_bands(a, preset->film))
    return fail({{"--crop", "a still in bands is drawn as a whole; expected --bands 1, too"}}, kWrongInput);
  std::set<fs::path> files{a.preset.path};
  files.insert(preset->files.begin(), preset->files.end());
  std::string named = environment_or("FROND_BIN", own_program().string());
  std::optional<fs::path> program = find_program(named);
  if (!program) return fail_run({{"", named + ": no such program"}}, kCouldNot);
  StopSignals stop;
  Result<fs::path> job =
      make_farm_folder(to.farm, call_of(a, preset->film), *program, {files.begin(), files.end()}, stop);
  if (!job) return fail_run(job.errors(), stop.asked() ? kInterrupted : kCouldNot);
  to.job = *job;
  std::error_code error;
  for (const fs::path& note : files_in(to.job / "failed")) fs::remove(note, error);
  fs::remove(to.job / "bands", error);
  Errors errors = write_surroundings(to.job, to.site);
  return errors.empty() ? int{kDone} : fail_run(errors, kCouldNot);
}

/// Finds out what is to be done. Pictures that are damaged go here, and so are made again.
int make_plan(const FarmArguments& a, Handed& to) {
  Result<FarmCall> call = read_farm_call(to.job);
  if (!call) return fail_run(call.errors(), kCouldNot);
  std::vector<std::string> options{"--film-only"};
  if (a.frames) options.push_back("--frames=" + *a.frames);
  Result<int> code = run(generate_command(to.job, *call, to.job, options));
  if (!code) return fail_run(code.errors(), kCouldNot);
  if (*code != kDone) return *code;
  constexpr int kMostElsewhere = 100'000;
  bool slurm = !a.hosts && !a.openjd && !a.opencue;
  Result<FarmPlan> plan =
      plan_farm(to.job, {count_of(a.chunk), count_of(a.bands), slurm ? most_slurm_tasks() : kMostElsewhere});
  if (!plan) return fail_run(plan.errors(), kCouldNot);
  to.plan = std::move(*plan);
  if (!to.plan.note.empty()) say(to.plan.note);
  return kDone;
}

}  // namespace

int farm(const FarmArguments& a) {
  if (std::string wrong = wrong_farm_words(a); !wrong.empty()) return fail_run({{"", wrong}}, kWrongInput);
  std::error_code error;
  const std::string& preset = a.preset.path;
  if (!fs::is_regular_file(preset, error))
    return fail_run({{"", preset + ": no such preset" + nearest_presets(preset)}}, kWrongInput);
  Handed to;
  to.name = fs::path(preset).stem();
  fs::path out = a.out.empty() ? fs::path("out") / to.name : fs::path(a.out);
  to.farm = fs::weakly_canonical(fs::absolute(out, error), error) / "farm";
  if (std::ranges::any_of(to.farm.string(), [](unsigned char c) { return c < ' ' || c == 127; }))
    return fail_run({{"", "the name of the folder holds a line break, which farms cannot bear"}},
                    kWrongInput);
  if (a.status || a.cancel || a.logs) return look_at(a, to.farm);
  if (a.site) {
    Result<std::string> text = read_file(*a.site);
    Result<FarmSite> site = text ? read_farm_site(*text, *a.site) : text.errors();
    if (!site) return fail(site.errors(), kWrongInput);
    to.site = std::move(*site);
  }
  if (int code = check_queue(a, to.farm); code != kDone) return code;
  if (int code = make_job(a, to); code != kDone) return code;
  if (int code = make_plan(a, to); code != kDone) return code;
  if (a.openjd || a.opencue) return write_job_files(to, a.openjd, a.opencue);
  if (a.hosts) return render_on_hosts(to, *a.hosts);
  return hand_to_slurm(to, a.partition);
}

}  // namespace frond
