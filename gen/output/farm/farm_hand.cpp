#include "farm/farm_hand.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include "core/files.h"
#include "core/text.h"
#include "jobs/escape.h"
#include "jobs/farm.h"
#include "jobs/jobs.h"
#include "render/process.h"
#include "render/slurm.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

FarmJob job_of(const Handed& film) {
  FarmJob job{.folder = film.job, .name = film.name, .work = film.plan.work, .uid = ::getuid()};
  if (std::string tasks = film.plan.tasks_text(); !tasks.empty()) job.tasks = tasks;
  if (const passwd* user = ::getpwuid(job.uid)) job.user = user->pw_name;
  return job;
}

/// What makes a task: the call of the job's own copy of a script.
std::vector<std::string> task_words(const Handed& film, int cpus, const std::vector<std::string>& work) {
  std::vector<std::string> words{(film.job / "tool" / "scripts" / "farm_task.sh").string(), film.job.string(),
                                 std::to_string(cpus)};
  words.insert(words.end(), work.begin(), work.end());
  return words;
}

std::string commas_to(const std::string& hosts, std::string_view other) {
  return fmt::format("{}", fmt::join(split(hosts, ','), other));
}

/// The tasks, each as a line that a shell reads, ended by a zero.
std::string task_lines(const Handed& film) {
  std::string lines;
  for (int task : film.plan.tasks) {
    std::vector<std::string> words = task_words(film, 0, film.plan.work);
    words.push_back(std::to_string(task));
    lines += "exec";
    for (const std::string& word : words) lines += " " + shell_quoted(word);
    lines += '\0';
  }
  return lines;
}

/// Notes the jobs of a film, so that --status and --cancel find them.
Errors note_jobs(const Handed& film, const std::string& jobs) {
  Result<bool> written = write_file(film.job / "jobs", jobs + "\n");
  return written ? Errors{} : written.errors();
}

}  // namespace

std::string jobs_in(const std::string& text) { return text.substr(0, text.find('\n')); }

std::vector<fs::path> results_of(const fs::path& farm) {
  std::vector<fs::path> results;
  std::error_code error;
  auto handed = fs::last_write_time(farm / "latest" / "manifest.json", error);
  if (error) return results;
  for (const std::string& name : result_files()) {
    fs::path file = farm.parent_path() / name;
    auto made = fs::last_write_time(file, error);
    if (!error && made > handed) results.push_back(file);
  }
  return results;
}

RenderedFilm write_job_files(const Handed& film, const std::optional<std::string>& openjd,
                             const std::optional<std::string>& opencue) {
  FarmJob job = job_of(film);
  RenderedFilm made;
  for (const auto& [file, text] : {std::pair(&openjd, &openjd_text), std::pair(&opencue, &opencue_text)}) {
    if (!*file) continue;
    if (Result<bool> written = write_file(**file, text(job, film.site)); !written)
      return {{written.errors()}, {}};
    made.results.emplace_back(**file);
  }
  return made;
}

RenderedFilm render_on_hosts(const Handed& film, const std::string& hosts, RunEvents& events) {
  events.report(fmt::format("Rendering {} on {}", film.plan.text(), commas_to(hosts, ", ")));
  // Lines that parallel reads are commands of a shell, for which their words are quoted.
  fs::path list = film.job / "tasks";
  if (Result<bool> written = write_file(list, task_lines(film)); !written) return {{written.errors()}, {}};
  Command command;
  command.words = {"parallel", "-0", "--will-cite"};
  command.add({"--sshlogin", "1/" + commas_to(hosts, ",1/"), "--retries", "3", "--joblog",
               (film.job / "log" / "hosts").string()});
  command.in = ::open(list.c_str(), O_RDONLY | O_CLOEXEC);
  command.out = 2;
  command.end_with = SIGTERM;
  Result<int> code = run(command);
  ::close(command.in);
  if (!code || *code != 0)
    return {{{{"", "not all frames could be rendered; those that are finished are kept"}}}, {}};
  Command last;
  last.words = task_words(film, 0, {"film"});
  last.end_with = SIGTERM;
  code = run(last);
  if (!code) return {{code.errors()}, {}};
  if (*code != 0) return {{{{"", film.job.string() + ": the film could not be made"}}}, {}};
  return {{}, results_of(film.farm)};
}

RenderedFilm hand_to_slurm(const Handed& film, const std::optional<std::string>& partition,
                           RunEvents& events) {
  std::vector<std::string> common = sbatch_words(job_of(film), film.site);
  if (partition) common.push_back("--partition=" + *partition);
  for (const char* word : {"--parsable", "--requeue", "--open-mode=append"}) common.emplace_back(word);
  common.push_back("--chdir=" + film.job.string());
  auto submit = [&](std::vector<std::string> words, const std::vector<std::string>& work) {
    words.insert(words.begin(), common.begin(), common.end());
    std::vector<std::string> task = task_words(film, film.site.cpus, work);
    words.insert(words.end(), task.begin(), task.end());
    return submit_to_slurm(words);
  };
  std::string array;
  std::vector<std::string> after;
  if (!film.plan.tasks.empty()) {
    Result<std::string> job =
        submit({"--array=" + film.plan.tasks_text(), "--output=log/%A_%a.log"}, film.plan.work);
    if (!job) return {{job.errors()}, {}};
    array = *job;
    if (Errors errors = note_jobs(film, array); !errors.empty()) return {{errors}, {}};
    after = {"--dependency=afterok:" + array, "--kill-on-invalid-dep=yes"};
  }
  after.emplace_back("--output=log/film_%j.log");
  Result<std::string> last = submit(after, {"film"});
  if (!last) return {{last.errors()}, {}};
  if (Errors errors = note_jobs(film, array + (array.empty() ? "" : ",") + *last); !errors.empty())
    return {{errors}, {}};
  events.report(array.empty() ? "Nothing to render: all frames are there"
                              : fmt::format("Submitted {} as job {}", film.plan.text(), array));
  events.report(fmt::format("Submitted the film as job {}; see --status", *last));
  return {};
}

}  // namespace frond
