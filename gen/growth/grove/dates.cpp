#include "grove/dates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grove/axes.h"

namespace frond {

namespace {

constexpr int kGustsFrom = 8;  // directions that storms come from

constexpr int kSearched = 6;       // nodes below a cut on which buds wake
constexpr std::size_t kWoken = 3;  // of them at most

/// Wakes buds on the nodes of an axis down from one.
void wake(Metamers& t, std::size_t from, const Falls& falls) {
  std::vector<std::uint8_t> branched(t.size());
  for (std::size_t i = 1; i < t.size(); ++i)
    if (t.has(i, Metamers::side_shoot) && falls.time[i] == Metamers::kNever) branched[t.parent[i]] = true;
  std::vector<std::size_t> asleep, free;
  auto i = static_cast<std::int32_t>(from);
  for (int k = 0; k < kSearched && i > 0 && !t.has(i, Metamers::dead); ++k, i = t.parent[i]) {
    if (t.has(i, Metamers::bud))
      asleep.push_back(i);
    else if (!branched[i] && !t.has(i, Metamers::spent))
      free.push_back(i);
    if (t.order[t.parent[i]] != t.order[i]) break;
  }
  const bool anew = asleep.empty();
  std::vector<std::size_t>& nodes = anew ? free : asleep;
  if (nodes.size() > kWoken) nodes.resize(kWoken);
  for (std::size_t node : nodes) {
    t.set(node, Metamers::woken);
    if (anew) t.set(node, Metamers::bud), t.set(node, Metamers::spent);
  }
}

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

std::vector<std::size_t> saw(Metamers& t, std::span<const YearCut> cuts, int year, Falls& falls,
                             std::vector<std::string>& notes) {
  std::vector<std::size_t> ends, below;
  std::vector<AxisNode> axes;
  std::vector<std::int32_t> starts;
  for (const YearCut& cut : cuts) {
    if (cut.year != year) continue;
    if (axes.empty()) {
      axes = nodal_axes(
          t.parent, t.order, t.tip, [&](std::size_t i) { return t.has(i, Metamers::regrown); },
          [](std::size_t) { return true; });
      starts = axis_starts({t.parent, axes});
    }
    Result<BranchPlace> place = find_place({t.parent, axes}, starts, cut.at);
    if (!place) {
      notes.push_back(fmt::format("/edits/{}/at: {} in that year", cut.number, place.errors().front().what));
      continue;
    }
    std::int32_t end = place->within < 0.5f ? t.parent[place->node] : place->node;
    if (end <= 0) end = t.size() > 1 ? 1 : 0;  // a stump is left of a stem
    const bool limb = starts[end] != starts[place->node];
    if (!limb) ends.push_back(static_cast<std::size_t>(end)), t.clear(end, Metamers::leading);
    below.push_back(static_cast<std::size_t>(end));
    std::vector<std::uint8_t> sawn(t.size());
    for (auto i = static_cast<std::size_t>(end) + 1; i < t.size(); ++i) {
      const bool first = limb ? static_cast<std::int32_t>(i) == place->node : t.parent[i] == end;
      sawn[i] = first || sawn[t.parent[i]];
      if (sawn[i]) falls.time[i] = static_cast<float>(year + 1);
    }
  }
  for (std::size_t end : below)
    if (falls.time[end] == Metamers::kNever) wake(t, end, falls);
  std::erase_if(ends, [&](std::size_t end) { return falls.time[end] != Metamers::kNever; });
  return ends;
}

}  // namespace frond
