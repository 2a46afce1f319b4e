#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace frond {

/// Settings of a site's farm for every task: a small JSON file.
struct FarmSite {
  std::string partition, account, qos;  ///< empty: the cluster's default
  int cpus = 1;                         ///< processors per task
  int memory = 0;                       ///< per task, MB; 0: the cluster's default
  int minutes = 0;                      ///< time limit of a task; 0: the cluster's default
  std::vector<std::string> modules;     ///< loaded by `module load` before a task
  std::vector<std::string> options;     ///< further options of sbatch
  std::string facility = "local", show = "testing", shot = "frond";  ///< where OpenCue files the job
};

/// Reads it from the text of a file; errors have their position.
Result<FarmSite> read_farm_site(std::string_view text, const std::string& file_name);

}  // namespace frond
