#pragma once

#include <span>
#include <string_view>

#include "grammar/figure.h"
#include "organisms/plant/plant.h"

// Organs that are whole flowers or inflorescences. A flower is several prototypes that stand together, one
// for each piece of one look; an inflorescence is none, but stalks of the figure and the sites of its
// flowers.

namespace frond {

/// How many prototypes stand together as one flower.
int piece_count(const FloralDiagram& diagram);
/// How many stages a flower has prototypes of: buds first, then open, then withered.
int stage_count(const FloralDiagram& diagram);
/// The number of the stage that is next to this one.
int stage_index(const FloralDiagram& diagram, double stage);

/// The prototypes of a flower: for each piece its stages; what has fallen has no parts.
std::vector<Prototype> flower_stages(const OrganParams& organ);

/// What is wrong with an organ's diagram or inflorescence; places are relative to the organ.
Errors flower_faults(std::span<const OrganParams> organs, std::size_t which);

/// Whether an inflorescence among the organs bears those of that symbol.
bool borne_by_others(std::span<const OrganParams> organs, std::string_view symbol);

/// Puts the stalks of inflorescences into a figure in metres, and in place of their sites those of their
/// flowers. Lots depend on `seed`, by the names of sites. Fails before it makes more than two million
/// florets.
Errors expand_inflorescences(Figure& figure, const PlantParams& params, std::span<const Prototype> prototypes,
                             Seed seed);

}  // namespace frond
