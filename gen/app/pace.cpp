#include "app/pace.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "core/printable.h"

namespace frond {

namespace {

std::filesystem::path pace_file() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* user = std::getenv("HOME");
  if (cache && *cache) return std::filesystem::path(cache) / "frond" / "pace";
  return std::filesystem::path(user ? user : "/") / ".cache" / "frond" / "pace";
}

/// As scripts/pace.sh writes it: one word.
std::string key_of(std::string_view preset) {
  std::string key(preset);
  std::ranges::replace_if(
      key, [](char c) { return !is_plain(c); }, '_');
  return key;
}

}  // namespace

Pace pace_of(std::string_view preset) {
  Pace pace;
  std::vector<double> all;
  std::ifstream in(pace_file());
  std::string wanted = key_of(preset), key;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    double foretold = 0, taken = 0;
    if (!(words >> key >> foretold >> taken) || !(foretold > 0) || !(taken > 0)) continue;
    all.push_back(taken / foretold);
    if (key == wanted) pace = {all.back(), "on its last run"};
  }
  if (pace.measured != Pace{}.measured || all.empty()) return pace;
  auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return {*middle, "on other runs of this machine"};
}

}  // namespace frond
