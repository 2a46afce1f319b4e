#pragma once

#include <string_view>

namespace frond {

/// How fast POV-Ray is here, by the runs that scripts/render.sh has noted in $XDG_CACHE_HOME/frond/pace
/// (~/.cache), one a line: preset, seconds foretold, seconds taken.
struct Pace {
  double factor = 1;  ///< of the seconds that are foretold
  std::string_view measured = "on no run of this machine";
};

/// That of the last run of the preset of that name; where there is none, the middle one of all.
Pace pace_of(std::string_view preset);

}  // namespace frond
