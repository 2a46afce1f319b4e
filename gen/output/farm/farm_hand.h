#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "farm/farm_plan.h"
#include "jobs/farm_site.h"
#include "pipeline/render_film.h"

namespace frond {

/// A film whose folder is made, and which is to be handed to machines.
struct Handed {
  std::string name;                 ///< of the preset
  std::filesystem::path farm, job;  ///< DIR/farm, and the folder of the job in it
  FarmSite site;
  FarmPlan plan;
};

/// Each hands it out in one way; the files that are there then.
RenderedFilm write_job_files(const Handed& film, const std::optional<std::string>& openjd,
                             const std::optional<std::string>& opencue);
/// Waits for the film, by GNU parallel; names with commas between them.
RenderedFilm render_on_hosts(const Handed& film, const std::string& hosts, RunEvents& events);
RenderedFilm hand_to_slurm(const Handed& film, const std::optional<std::string>& partition,
                           RunEvents& events);

/// What lies in DIR of the film that was handed over last: film, sheet, still.
std::vector<std::filesystem::path> results_of(const std::filesystem::path& farm);

/// The numbers in a job's file `jobs`, with commas between them.
std::string jobs_in(const std::string& text);

}  // namespace frond
