#include "core/figures.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace frond {

std::string bytes_text(double bytes) {
  constexpr const char* kUnits[] = {"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
  std::size_t unit = 0;
  if (bytes < 999.5) return fmt::format("{:.0f} bytes", bytes);
  for (; bytes >= 999.5 && unit + 1 < std::size(kUnits); ++unit) bytes /= 1000;
  return bytes < 999.5 ? fmt::format("{:.3g} {}", bytes, kUnits[unit]) : "more than 1000 EB";
}

std::string seconds_text(double seconds) {
  if (seconds < 0.01) return "0.01 s";
  if (seconds < 99.5) return fmt::format("{:.2g} s", seconds);
  if (seconds < 5970) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 359'820) return fmt::format("{:.1f} h", seconds / 3600);
  if (seconds < 8.64e9) return fmt::format("{:.0f} days", seconds / 86'400);
  return "more than 100000 days";
}

std::string count_text(double count) {
  if (count < 999'999.5) return fmt::format("{:.0f}", count);
  if (count < 999.5e6) return fmt::format("{:.3g} million", count / 1e6);
  if (count < 999.5e9) return fmt::format("{:.3g} billion", count / 1e9);
  return fmt::format("10^{:.0f}", std::floor(std::log10(count)));
}

}  // namespace frond
