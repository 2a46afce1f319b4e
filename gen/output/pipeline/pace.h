#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace frond {

/// How fast POV-Ray is here, by the last runs of `frond render`, which are noted in
/// $XDG_CACHE_HOME/frond/pace
/// (~/.cache), one a line: the key of the preset, seconds estimated, seconds taken.
struct Pace {
  double factor = 1;  ///< of the seconds that are estimated
  std::string_view measured = "on no run of this machine";
};

/// By which the pace of the preset in a file is kept: its whole path, links resolved, so that two of one name
/// in two folders have each their own.
std::string pace_key(const std::filesystem::path& preset);

/// That of the last run of the preset of that key; where there is none, the middle one of all.
Pace pace_of(std::string_view key);

/// Notes a run: the seconds of processor that were estimated for the preset of that key, and those that it
/// took. The last 50 presets are kept. Where nothing can be written there is no note.
void note_pace(std::string_view key, double estimate, double taken);

/// Where nothing is noted yet, has POV-Ray render a small picture, which takes a second or two.
void measure_machine(const std::string& povray);

}  // namespace frond
