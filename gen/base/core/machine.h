#pragma once

#include <filesystem>
#include <limits>

namespace frond {

/// The resources of a machine that are available to a run: a plain value, so that tests can make one up.
struct Machine {
  static constexpr double kUnlimited = std::numeric_limits<double>::infinity();

  double memory = kUnlimited;  ///< bytes that this process may still allocate
  double disk = kUnlimited;    ///< bytes free where the output goes
  int threads = 1;             ///< number of threads of parallel_for
};

/// The resources of this process: memory is the least of what is available, what its cgroups allow and what
/// its address space allows (ulimit -v); disk is that of `out`, which need not exist yet. /proc and /sys are
/// read below `root`.
Machine this_machine(const std::filesystem::path& out, const std::filesystem::path& root = "/");

/// Memory in use by the process, bytes; 0 where unknown.
double memory_in_use();

}  // namespace frond
