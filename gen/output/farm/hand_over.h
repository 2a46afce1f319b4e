#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "jobs/farm_site.h"
#include "pipeline/render_film.h"

namespace frond {

/// A film that other machines are to render: through Slurm, or as the last four say.
struct FarmOrder {
  std::filesystem::path file;  ///< of the preset
  std::optional<std::filesystem::path> assets =
      {};  ///< the only folder to read from besides the preset's own
  std::vector<std::string> words =
      {};  ///< what `frond generate` is told besides these, as `--set` and its value
  std::filesystem::path out, program;      ///< the folder of the film; `frond`, which is copied for the tasks
  std::optional<std::string> frames = {};  ///< A-B; none: all
  std::optional<bool> resolve = {};        ///< see is_resolved(); never of a still in bands
  int chunk = 4, bands = 8;                ///< frames a task; tasks of a still
  FarmSite site = {};
  std::optional<std::string> partition = {};  ///< of Slurm
  std::optional<std::string> hosts = {};      ///< names with commas between them: over ssh, by GNU parallel
  std::optional<std::string> openjd = {}, opencue = {};  ///< files to write for farms that read them
};

/// Where what farms make of the film in a folder is kept: the folder `farm` there.
std::filesystem::path farm_folder(const std::filesystem::path& out);

/// Makes the folder of the job, finds out what is to be done, and hands it over; waits only for hosts.
RenderedFilm hand_over(const FarmOrder& order, const Preset& preset, Stop& stop, RunEvents& events);

/// Ends what Slurm was last handed from there.
Errors cancel_farm(const std::filesystem::path& farm);

}  // namespace frond
