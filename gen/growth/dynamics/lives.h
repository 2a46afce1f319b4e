#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace frond {

// What stands and reefs share: lives with sizes over time, and species that are named.

/// A size of a life, as it was noted.
template <class Size>
struct NotedSize {
  std::uint32_t life = 0;
  Size size;
};

/// Brings together the sizes of each life of a history, which were noted in the order of time.
template <class History, class Size>
void gather_sizes(History& history, const std::vector<NotedSize<Size>>& noted) {
  for (const auto& n : noted) ++history.lives[n.life].count;
  std::uint32_t first = 0;
  for (auto& life : history.lives) life.first = first, first += life.count, life.count = 0;
  history.sizes.resize(noted.size());
  for (const auto& n : noted) {
    auto& life = history.lives[n.life];
    history.sizes[life.first + life.count++] = n.size;
  }
}

/// Faults of a stand or a reef, as `what` says, in its species and those planted.
template <class Text>
Errors species_faults(const Text& text, std::string_view what) {
  Errors faults;
  std::vector<decltype(text.species[0].name)> names;
  for (std::size_t i = 0; i < text.species.size(); ++i) {
    auto name = text.species[i].name;
    if (std::ranges::find(names, name) != names.end())
      faults.push_back(error_at(fmt::format("/species/{}/name", i),
                                "a second \"{}\"; expected each species once", name_of(name)));
    names.push_back(name);
  }
  for (std::size_t i = 0; i < text.planted.size(); ++i)
    if (!names.empty() && std::ranges::find(names, text.planted[i].name) == names.end())
      faults.push_back(error_at(fmt::format("/planted/{}/name", i),
                                "\"{}\" is not among the species of the {}; expected one of them",
                                name_of(text.planted[i].name), what));
  return faults;
}

/// Adds the fault of the years that a film shows of a stand or a reef, if there is one.
template <class Text>
void add_shown_fault(const Text& text, Errors& faults) {
  if (text.shown && (text.shown->x > text.shown->y || text.shown->y > static_cast<float>(text.years)))
    faults.push_back(error_at("/shown", "found {:g} to {:g}; expected years in order, up to the last one, {}",
                              text.shown->x, text.shown->y, text.years));
}

}  // namespace frond
