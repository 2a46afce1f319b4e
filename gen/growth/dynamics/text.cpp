#include <fmt/format.h>

#include <algorithm>

#include "dynamics/stand.h"

namespace frond {

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
  Errors faults;
  std::vector<TreeName> names;
  for (std::size_t i = 0; i < text.species.size(); ++i) {
    TreeName name = text.species[i].name;
    if (std::ranges::find(names, name) != names.end())
      faults.push_back({fmt::format("/species/{}/name", i),
                        fmt::format("a second \"{}\"; expected each species once", name_of(name))});
    names.push_back(name);
  }
  auto known = [&](const std::string& where, TreeName name) {
    if (!names.empty() && std::ranges::find(names, name) == names.end())
      faults.push_back(
          {where,
           fmt::format("\"{}\" is not among the species of the stand; expected one of them", name_of(name))});
  };
  for (std::size_t i = 0; i < text.planted.size(); ++i)
    known(fmt::format("/planted/{}/name", i), text.planted[i].name);
  return faults;
}

}  // namespace frond
