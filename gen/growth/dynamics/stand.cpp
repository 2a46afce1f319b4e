#include "dynamics/stand.h"

#include <algorithm>

#include "core/curve.h"
#include "dynamics/lives.h"

namespace frond {

namespace {

/// The slope of a course at its point i, harmonic mean of those beside it (Fritsch and Butland 1984): what
/// only rises goes on rising. 0 at its ends.
float course_slope(std::span<const TreeSize> sizes, std::size_t i, float TreeSize::*of) {
  if (i == 0 || i + 1 >= sizes.size()) return 0;
  float before = (sizes[i].*of - sizes[i - 1].*of) / std::max(sizes[i].year - sizes[i - 1].year, 1e-3f);
  float after = (sizes[i + 1].*of - sizes[i].*of) / std::max(sizes[i + 1].year - sizes[i].year, 1e-3f);
  return before * after > 0 ? 2 * before * after / (before + after) : 0;
}

}  // namespace

StandOptions options_of(const StandText& text) {
  StandOptions options{.area = text.area,
                       .years = text.years,
                       .species = {},
                       .planted = text.planted,
                       .seeding = text.seeding,
                       .storms = text.storms,
                       .temperature = text.temperature,
                       .events = {}};
  if (text.species.empty()) options.species.assign(tree_species().begin(), tree_species().end());
  for (const TreeText& wanted : text.species) {
    TreeSpecies tree = species(wanted.name);
    tree.height = wanted.height.value_or(tree.height);
    tree.girth_gain = wanted.girth_gain.value_or(tree.girth_gain);
    tree.tolerance = wanted.tolerance.value_or(tree.tolerance);
    tree.lifespan = wanted.lifespan.value_or(tree.lifespan);
    tree.anchorage = wanted.anchorage.value_or(tree.anchorage);
    tree.reach = wanted.reach.value_or(tree.reach);
    tree.seeds = wanted.seeds.value_or(tree.seeds);
    tree.arrival = wanted.arrival.value_or(tree.arrival);
    tree.coldest = wanted.coldest.value_or(tree.coldest);
    tree.moisture = wanted.moisture.value_or(tree.moisture);
    options.species.push_back(tree);
  }
  return options;
}

Errors stand_faults(const StandText& text) {
  Errors faults = species_faults(text, "stand");
  add_shown_fault(text, faults);
  return faults;
}

TreeSize size_at(const StandHistory& history, std::uint32_t life, double year) {
  const TreeLife& lived = history.lives[life];
  std::span<const TreeSize> sizes = std::span(history.sizes).subspan(lived.first, lived.count);
  auto when = static_cast<float>(year);
  auto after = std::ranges::upper_bound(sizes, when, {}, &TreeSize::year);
  if (after == sizes.begin()) return {.year = when};
  auto i = static_cast<std::size_t>(after - sizes.begin()) - 1, next = std::min(i + 1, sizes.size() - 1);
  const TreeSize &a = sizes[i], &b = sizes[next];
  float span = b.year - a.year;
  Hermite w =
      hermite(span > 0 ? std::min((year - static_cast<double>(a.year)) / static_cast<double>(span), 1.0) : 0);
  auto at = [&](float TreeSize::*of) {
    auto slope = [&](std::size_t point) {
      return static_cast<double>(course_slope(sizes, point, of) * span);
    };
    return static_cast<float>(w.start * static_cast<double>(a.*of) + w.end * static_cast<double>(b.*of) +
                              w.start_slope * slope(i) + w.end_slope * slope(next));
  };
  return {when, at(&TreeSize::height), at(&TreeSize::diameter), at(&TreeSize::crown_radius),
          at(&TreeSize::crown_base)};
}

std::vector<std::uint32_t> living_at(const StandHistory& history, double year) {
  std::vector<std::uint32_t> living;
  for (std::uint32_t i = 0; i < history.lives.size(); ++i)
    if (static_cast<double>(history.lives[i].born) <= year &&
        year < static_cast<double>(history.lives[i].died))
      living.push_back(i);
  return living;
}

std::vector<Deadwood> deadwood_at(const StandHistory& history, double year) {
  std::vector<Deadwood> dead;
  auto when = static_cast<float>(year);
  for (std::uint32_t i = 0; i < history.lives.size(); ++i) {
    const TreeLife& life = history.lives[i];
    if (life.died <= when && when < life.rotted)
      dead.push_back({i, life.fell <= when, (when - life.died) / (life.rotted - life.died)});
  }
  return dead;
}

double stem_mass(const TreeSpecies& species, const TreeSize& size) {
  double radius = static_cast<double>(size.diameter) / 2;
  return 0.45 * kPi * radius * radius * static_cast<double>(size.height) * species.density;
}

}  // namespace frond
