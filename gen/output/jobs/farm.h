#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "jobs/farm_site.h"

/// The files that submit a film to a render farm. Each task is one call that can be repeated anywhere, at any
/// time:
///
///     FOLDER/tool/scripts/farm_task.sh FOLDER CPUS WORK... NUMBER
///     FOLDER/tool/scripts/farm_task.sh FOLDER CPUS film          once all of those are done
namespace frond {

/// A film as a farm job.
struct FarmJob {
  std::string folder;             ///< of the job, with the same path on every machine
  std::string name = "frond";     ///< see job_name
  std::string tasks = "1";        ///< numbers and ranges: 1,3,7-9
  std::vector<std::string> work;  ///< arguments of each task, before its number
  std::string user = "frond";     ///< the owner, and the numeric id of that user
  unsigned uid = 1000;
};

/// A text as a valid job name: letters, digits, dots, dashes and underscores, 64 at most.
std::string job_name(std::string_view text);

/// Command line arguments of sbatch.
std::vector<std::string> sbatch_words(const FarmJob& job, const FarmSite& site);
/// A template of Open Job Description, jobtemplate-2023-09.
std::string openjd_text(const FarmJob& job, const FarmSite& site);
/// A job of OpenCue in CJSL 1.15.
std::string opencue_text(const FarmJob& job, const FarmSite& site);

}  // namespace frond
