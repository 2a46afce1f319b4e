#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"
#include "preset/describe.h"

namespace frond {

/// A leaf, a flower or a fruit of a species.
struct TaxonPart {
  std::string organ;  ///< the name of that which is it; empty: it is none of its own
  double share = 1;   ///< of that one's length, where it is a sprig of several
  Vec2 size{0, 0};    ///< smallest and largest length or diameter that is usual, metres
};

/// What is known of the species that a preset's first organism is: its names, its sizes when it is grown and
/// the months in which it flowers. Changes nothing that grows; tests hold the organism to it, and it is found
/// by these names.
struct Taxon {
  std::string latin;
  std::vector<std::string> names;  ///< everyday ones
  std::optional<Vec2> height;      ///< smallest and largest that is usual, metres
  std::optional<Vec2> spread;      ///< width, likewise
  std::optional<TaxonPart> leaf, flower, fruit;
  std::optional<TaxonPart> body;                     ///< of an animal of a school
  std::optional<Vec2> flowering, fruiting, in_leaf;  ///< first and last month, 1 to 12; may pass the new year
  std::string source;                                ///< where the ranges come from
};

void describe(Properties& v, Taxon& t);

/// A preset that comes with Frond and tells its taxon.
struct ShippedSpecies {
  std::filesystem::path file;
  Taxon taxon;
};

/// All of them, by their paths.
std::vector<ShippedSpecies> shipped_species();

/// The shipped preset that a word names: by its path or its file's name as shipped_preset() finds it, or else
/// by a Latin or everyday name of its species, whose capitals, hyphens and underscores do not count.
std::optional<std::filesystem::path> shipped_by_name(std::string_view name);

}  // namespace frond
