#pragma once

#include <filesystem>
#include <limits>

namespace frond {

/// What a machine has left for a run: a plain value, so that one can be made up.
struct Machine {
  static constexpr double kNoEnd = std::numeric_limits<double>::infinity();

  double memory = kNoEnd;  ///< bytes that this process may still take
  double disk = kNoEnd;    ///< bytes free where the output goes
  int threads = 1;         ///< that parallel_for runs on
};

/// That of this process: the least of the memory that is available, that its cgroups leave it and that its
/// address space may still grow by (ulimit -v); the disk that holds `out` or is to. `root` is that of /proc
/// and /sys.
Machine this_machine(const std::filesystem::path& out, const std::filesystem::path& root = "/");

/// Memory that the process takes now, bytes; 0 where the system does not tell.
double memory_in_use();

}  // namespace frond
