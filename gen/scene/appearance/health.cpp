#include "appearance/health.h"

#include <algorithm>

namespace frond {

Fare fare_at(const Health& health, double time, double delay) {
  time -= delay;
  // Between two keys it keeps to what is between their values, but for handles, which may go beyond.
  auto at = [&](double when) { return static_cast<float>(std::clamp(health.at.at(when), 0.0, 1.0)); };
  Fare fare{at(time), at(time)};
  for (const auto& key : health.at.keys())
    if (key.time <= time) fare.least = std::min(fare.least, at(key.time));
  return fare;
}

}  // namespace frond
