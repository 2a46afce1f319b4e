#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

namespace frond {

/// How a film may be cut up.
struct FarmLimits {
  int chunk = 4;  ///< frames a task
  int bands = 8;  ///< of a still
  int most = 1;   ///< tasks that the farm takes
};

/// The tasks that make the pictures of a job.
struct FarmPlan {
  std::vector<std::string> work;  ///< what each is told before its number
  std::vector<int> tasks;         ///< those that have something to do
  int all = 1;                    ///< how many there are
  int chunk = 1;
  bool bands = false;
  std::string note;  ///< for people; empty where there is nothing to say

  /// The tasks as 1,3,7-9; empty where there is nothing to do.
  std::string tasks_text() const;

  /// How many of how many tasks have something to do, in words.
  std::string text() const;
};

/// That of a job whose folder `frond generate --film-only` has written; notes there into how many bands a
/// still is cut.
Result<FarmPlan> plan_farm(const std::filesystem::path& folder, const FarmLimits& limits);

/// The name of the picture of a band of a still, and into how many of them that of a job is cut; 0: none.
std::string band_name(int band, int bands);
int bands_of(const std::filesystem::path& folder);

/// How many pictures of a job there are, in words.
std::string farm_status(const std::filesystem::path& folder);

}  // namespace frond
