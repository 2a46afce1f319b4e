#include "grove/saw.h"

#include <fmt/format.h>

#include <algorithm>

#include "grove/axes.h"

namespace frond {

namespace {

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
