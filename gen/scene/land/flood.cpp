#include "land/flood.h"
#include "core/cancellation.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace frond {

Flood priority_flood(const GroundGrid& ground) {
  constexpr auto kUnknown = static_cast<std::size_t>(-1);
  Flood flood{ground.height, std::vector<std::size_t>(ground.height.size(), kUnknown)};
  using Open = std::pair<float, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  auto reach = [&](std::size_t point, std::size_t from, float level) {
    if (flood.next[point] != kUnknown) return;
    flood.next[point] = from;
    flood.level[point] = std::max(flood.level[point], level);
    open.emplace(flood.level[point], point);
  };
  for (int row = 0; row < ground.side; ++row)
    for (int column = 0; column < ground.side; ++column) {
      bool rim = row == 0 || column == 0 || row == ground.side - 1 || column == ground.side - 1;
      std::size_t k = ground.index(column, row);
      if (rim || (!ground.drain.empty() && ground.drain[k])) reach(k, k, ground.height[k]);
    }
  constexpr std::size_t kRound = 4096;
  for (std::size_t done = 0; !open.empty();) {
    auto [level, at] = open.top();
    open.pop();
    if (++done % kRound == 0) stay_wanted();
    each_beside(ground, at, [&](std::size_t k) { reach(k, at, level); });
  }
  return flood;
}

}  // namespace frond
