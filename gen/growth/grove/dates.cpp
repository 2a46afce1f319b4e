#include "grove/dates.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

constexpr int kGustsFrom = 8;  // directions that storms come from

}  // namespace

Weather weather_of(double wind, double snow, const Dates& dates, Seed seed, int year) {
  Seed weather = seed.child("weather").child(static_cast<std::uint64_t>(year));
  double from = 2 * kPi * static_cast<double>(weather.child(0).bits() % kGustsFrom) / kGustsFrom;
  double speed = wind * weather.child(1).range(0.7, 1.0);
  Vec3 toward(std::cos(from), 0, std::sin(from));
  for (const auto& [when, event] : dates.events) {
    if (when != year || event.storm <= 0) continue;
    speed = std::max(speed, storm_gust(wind, event.storm));
    toward = dates.toward.value_or(toward);
  }
  auto blows = static_cast<float>(speed);
  return {Vec3(blows * toward.x, 0, blows * toward.z), snow * weather.child(2).range(0.5, 1.0)};
}

std::vector<std::uint8_t> felled_in(const Dates& dates, int year, std::span<const FellingTree> trees,
                                    Seed seed) {
  std::vector<std::uint8_t> felled(trees.size());
  for (std::size_t e = 0; e < dates.events.size(); ++e) {
    const auto& [when, event] = dates.events[e];
    if (when != year || !event.cut) continue;
    std::vector<std::pair<std::uint64_t, std::size_t>> drawn;
    for (std::size_t i = 0; i < trees.size(); ++i) {
      if (!trees[i].stands || felled[i] || !concerns(event.cut->entry, trees[i].name)) continue;
      Seed lot = event.cut->by_own ? trees[i].seed.child("cut", e) : seed.child("cut", e).child(i);
      drawn.emplace_back(lot.bits(), i);
    }
    std::sort(drawn.begin(), drawn.end());
    drawn.resize(static_cast<std::size_t>(std::lround(event.cut->share * static_cast<double>(drawn.size()))));
    for (auto [_, i] : drawn) felled[i] = true;
  }
  return felled;
}

double pruned_in(const Dates& dates, int year, const std::string& name) {
  double below = 0;
  for (const auto& [when, event] : dates.events)
    if (when == year && event.prune && concerns(event.prune->entry, name))
      below = std::max(below, event.prune->below);
  return below;
}

void prune(const Metamers& t, double below, Seed seed, int year, Falls& falls) {
  if (below <= 0) return;
  for (std::size_t i = 1; i < t.size(); ++i) {
    auto p = static_cast<std::size_t>(t.parent[i]);
    bool limb = t.order[p] == 0 && t.order[i] > 0;
    if (falls.time[p] != Metamers::kNever && t.order[i] > 0)
      falls.time[i] = falls.time[p];
    else if (limb && falls.time[i] == Metamers::kNever && t.tip[p].y - t.tip[0].y < static_cast<float>(below))
      falls.time[i] = static_cast<float>(year + 1 + 0.9 * seed.child(t.serial[i]).child(13).unit());
  }
}

}  // namespace frond
