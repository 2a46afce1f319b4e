#pragma once

#include <algorithm>
#include <span>
#include <typeindex>
#include <vector>

#include "organisms/organism.h"
#include "preset/describe.h"

namespace frond {

/// All kinds of organisms, one row each, in the order of listings. Row `x` is the folder x, which defines
/// `Kind<Organism> x_kind()`.
#define FROND_KINDS(row)                                                                                \
  row(coral) row(massive) row(columnar) row(foliose) row(table) row(encrusting) row(tube) row(mushroom) \
      row(fan) row(shell) row(plant) row(rock) row(pebbles) row(wall) row(column) row(mesh) row(bridge) \
          row(vase) row(trellis) row(weber_penn) row(colonized) row(tree) row(ivy) row(school)

#define FROND_DECLARE(name) Kind<Organism> name##_kind();
FROND_KINDS(FROND_DECLARE)
#undef FROND_DECLARE

/// Their table.
std::span<const Kind<Organism>> organism_kinds();

/// The row of a kind, from its grower class with described parameters, see organisms/grower.h. Its
/// `kLeading`, if it has one, names the dozen properties that shape it most, as paths: the studio shows them
/// first.
template <class G>
Kind<Organism> make_grower(std::string_view name, std::string_view doc) {
  return {name, doc, [](Properties& v, Organism& organism) {
            auto grower = std::make_shared<G>();
            describe(v, grower->params);
            if constexpr (requires { G::kLeading; }) v.leading(G::kLeading);
            organism.grower = std::move(grower);
          }};
}

/// Groups things of organisms by kind, in the order of first occurrence; `organism_of` returns the organism
/// of a thing.
template <class Thing, class OrganismOf>
std::vector<std::vector<Thing>> by_kind(const std::vector<Thing>& things, const OrganismOf& organism_of) {
  std::vector<std::type_index> kinds;
  std::vector<std::vector<Thing>> lists;
  for (const Thing& thing : things) {
    const Grower& grower = *organism_of(thing)->grower;
    std::size_t k = static_cast<std::size_t>(std::ranges::find(kinds, typeid(grower)) - kinds.begin());
    if (k == kinds.size()) kinds.emplace_back(typeid(grower)), lists.emplace_back();
    lists[k].push_back(thing);
  }
  return lists;
}

}  // namespace frond
