#include "farm/hand_over.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/files.h"
#include "farm/farm_folder.h"
#include "farm/farm_hand.h"
#include "farm/farm_plan.h"
#include "render/process.h"
#include "render/slurm.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// What is not there that the film is to be handed to.
Outcome check_queue(const FarmOrder& order, const fs::path& farm) {
  if (order.hosts && !find_program("parallel"))
    return {{{"", "parallel: no such program; --hosts needs GNU parallel: apt-get install parallel"}}};
  if (order.hosts || order.openjd || order.opencue) return {};
  if (!find_program("sbatch"))
    return {{{"",
              "sbatch: no such program; this machine is no part of a Slurm cluster; --hosts and "
              "--openjd need none"}}};
  if (order.partition && !has_slurm_partition(*order.partition)) {
    Result<std::vector<std::string>> there = slurm_partitions();
    if (!there) return {there.errors()};
    std::string names;
    for (const std::string& name : *there) names += " " + name;
    return {{error_at("", "--partition: there is no '{}'; there is{}", *order.partition, names)}, true};
  }
  Result<std::string> jobs = read_file(farm / "latest" / "jobs");
  if (jobs && !slurm_tasks(jobs_in(*jobs), "PENDING,RUNNING,COMPLETING").empty())
    return {{{"", farm.string() + ": a farm is at work there; see --status, or end it with --cancel"}}, true};
  return {};
}

/// Whether a still is drawn in bands, which are joined as they are.
bool in_bands(const FarmOrder& order, const Film& film) { return film.frames == 1 && order.bands > 1; }

FarmCall call_of(const FarmOrder& order, const Film& film) {
  std::error_code error;
  auto whole = [&](const fs::path& path) {
    fs::path from_root = fs::absolute(path, error).lexically_normal();
    return from_root.has_filename() ? from_root : from_root.parent_path();
  };
  FarmCall call{fs::current_path(error), whole(order.file), {}, order.words};
  if (order.assets) call.assets = whole(*order.assets);
  call.options.push_back(!in_bands(order, film) && is_resolved(film, order.resolve) ? "--resolve"
                                                                                    : "--no-resolve");
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
Outcome make_job(const FarmOrder& order, const Preset& preset, Handed& to, Stop& stop) {
  if (Errors errors = refuse_resolving(preset.film, order.resolve); !errors.empty()) return {errors, true};
  if (preset.film.crop && in_bands(order, preset.film))
    return {{{"--crop", "a still in bands is drawn as a whole; expected --bands 1, too"}}, true};
  std::set<fs::path> files{order.file};
  files.insert(preset.files.begin(), preset.files.end());
  std::optional<fs::path> program = find_program(order.program.string());
  if (!program) return {{{"", order.program.string() + ": no such program"}}};
  Result<fs::path> job =
      make_farm_folder(to.farm, call_of(order, preset.film), *program, {files.begin(), files.end()}, stop);
  if (!job) return {job.errors(), false, stop.asked()};
  to.job = *job;
  for (const fs::path& note : files_in(to.job / "failed")) remove_file(note);
  remove_file(to.job / "bands");
  return {write_surroundings(to.job, to.site)};
}

/// Finds out what is to be done. Pictures that are damaged go here, and so are made again.
Outcome make_plan(const FarmOrder& order, Handed& to, RunEvents& events) {
  Result<FarmCall> call = read_farm_call(to.job);
  if (!call) return {call.errors()};
  std::vector<std::string> options{"--film-only"};
  if (order.frames) options.push_back("--frames=" + *order.frames);
  Command command = generate_command(to.job, *call, to.job, options);
  OutputCapture said;
  command.err = said.descriptor();
  Result<int> code = run(command);
  if (!code) return {code.errors()};
  constexpr int kWrongInput = 2;
  Errors errors;
  for (const std::string& line : lines_of(said.text()))
    if (*code == 0)
      events.note(line);
    else
      errors.push_back({"", line});
  if (*code != 0 && errors.empty()) errors = {error_at("", "frond ended with exit code {}", *code)};
  if (*code != 0) return {errors, *code == kWrongInput};
  constexpr int kMostElsewhere = 100'000;
  bool slurm = !order.hosts && !order.openjd && !order.opencue;
  Result<FarmPlan> plan =
      plan_farm(to.job, {order.chunk, order.bands, slurm ? most_slurm_tasks() : kMostElsewhere});
  if (!plan) return {plan.errors()};
  to.plan = std::move(*plan);
  if (!to.plan.note.empty()) events.note(to.plan.note);
  return {};
}

}  // namespace

fs::path farm_folder(const fs::path& out) {
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(out, error), error) / "farm";
}

RenderedFilm hand_over(const FarmOrder& order, const Preset& preset, Stop& stop, RunEvents& events) {
  Handed to{order.file.stem(), farm_folder(order.out), {}, order.site, {}};
  if (std::ranges::any_of(to.farm.string(), [](unsigned char c) { return c < ' ' || c == 127; }))
    return {{{{"", "the name of the folder holds a line break, which farms cannot bear"}}, true}, {}};
  Outcome ready = check_queue(order, to.farm);
  if (ready.well()) ready = make_job(order, preset, to, stop);
  if (ready.well()) ready = make_plan(order, to, events);
  if (!ready.well()) return {std::move(ready), {}};
  if (order.openjd || order.opencue) return write_job_files(to, order.openjd, order.opencue);
  if (order.hosts) return render_on_hosts(to, *order.hosts, events);
  return hand_to_slurm(to, order.partition, events);
}

Errors cancel_farm(const fs::path& farm) {
  if (!find_program("scancel"))
    return {{"", "scancel: no such program; this machine is no part of a Slurm cluster"}};
  Result<std::string> jobs = read_file(farm / "latest" / "jobs");
  return jobs ? cancel_in_slurm(jobs_in(*jobs)) : Errors{};
}

}  // namespace frond
