#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace frond {

/// What a site's farm needs to know of every task: a small JSON file.
struct FarmSite {
  std::string partition, account, qos;  ///< empty: the cluster's own choice
  int cpus = 1;                         ///< that a task renders with
  int memory = 0;                       ///< of a task, MB; 0: the cluster's own choice
  int minutes = 0;                      ///< that a task may take; 0: the same
  std::vector<std::string> modules;     ///< loaded by `module load` before a task
  std::vector<std::string> options;     ///< further options of sbatch
  std::string facility = "local", show = "testing", shot = "frond";  ///< where OpenCue files the job
};

/// Reads it from the text of a file; what is wrong is told with its place.
Result<FarmSite> read_farm_site(std::string_view text, const std::string& file_name);

}  // namespace frond
