#include "core/machine.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/parallel.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// The number behind a word at the start of a line; -1 where there is none.
double number_after(std::istream& in, const std::string& word) {
  for (std::string line; std::getline(in, line);) {
    std::istringstream parts(line);
    double number = -1;
    if (std::string first; parts >> first && first == word && parts >> number) return number;
  }
  return -1;
}

/// A file that holds one number; `otherwise` where it holds none, as where it says "max".
double number_in(const fs::path& path, double otherwise) {
  std::ifstream in(path);
  double number = 0;
  return in >> number ? number : otherwise;
}

/// What one cgroup leaves. Files that were read and are not in use make room.
double left_by(const fs::path& folder, const char* most, const char* used, const char* reclaimable) {
  double limit = number_in(folder / most, Machine::kUnlimited);
  if (limit > 1e18) return Machine::kUnlimited;  // how the first version says that there is none
  std::ifstream in(folder / "memory.stat");
  double in_use = number_in(folder / used, 0) - std::max(0.0, number_after(in, reclaimable));
  return std::max(0.0, limit - std::max(0.0, in_use));
}

/// The least that the cgroups of the process leave, and those that they are in. Where a container sees only
/// its own, its path leads nowhere, but one above it does.
double left_by_cgroups(const fs::path& root) {
  double left = Machine::kUnlimited;
  std::ifstream in(root / "proc/self/cgroup");
  for (std::string line; std::getline(in, line);) {
    std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == line.npos) continue;
    std::string kinds = "," + line.substr(first + 1, second - first - 1) + ",";
    bool unified = kinds == ",,";
    if (!unified && kinds.find(",memory,") == kinds.npos) continue;
    fs::path top = root / (unified ? "sys/fs/cgroup" : "sys/fs/cgroup/memory");
    fs::path folder = fs::path(line.substr(second + 1)).relative_path().lexically_normal();
    for (;; folder = folder.parent_path()) {
      left = std::min(left, unified ? left_by(top / folder, "memory.max", "memory.current", "inactive_file")
                                    : left_by(top / folder, "memory.limit_in_bytes", "memory.usage_in_bytes",
                                              "total_inactive_file"));
      if (folder.empty()) break;
    }
  }
  return left;
}

/// How much the address space may still grow.
double left_by_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return Machine::kUnlimited;
  double pages = number_in("/proc/self/statm", 0);
  return std::max(0.0,
                  static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(::sysconf(_SC_PAGESIZE)));
}

}  // namespace

Machine this_machine(const fs::path& out, const fs::path& root) {
  Machine machine;
  std::ifstream in(root / "proc/meminfo");
  if (double kilobytes = number_after(in, "MemAvailable:"); kilobytes >= 0) machine.memory = 1024 * kilobytes;
  machine.memory = std::min({machine.memory, left_by_cgroups(root), left_by_limit()});
  std::error_code error;
  fs::path there = fs::absolute(out, error);
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  if (fs::space_info space = fs::space(there, error); !error)
    machine.disk = static_cast<double>(space.available);
  machine.threads = thread_count();
  return machine;
}

double memory_in_use() {
  std::ifstream in("/proc/self/statm");
  double all = 0, resident = 0;
  return in >> all >> resident ? resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace frond
