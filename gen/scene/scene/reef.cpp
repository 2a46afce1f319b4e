#include "scene/reef.h"

#include <cmath>

namespace frond {

ReefHistory reef_history(const Preset& preset) {
  ReefOptions options = options_of(*preset.reef);
  for (const Event& event : preset.events)
    if (event.storm > 0 || event.heat > 0)
      options.events.push_back({.year = std::max(1, static_cast<int>(std::lround(event.year))),
                                .storm = event.storm,
                                .heat = event.heat});
  return simulate_reef(options, Seed{preset.seed}.child("reef"));
}

}  // namespace frond
