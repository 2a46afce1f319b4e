#pragma once

#include <span>

#include "export/maker.h"

namespace frond {

/// Whether a model is nothing but organs and bodies that are those of another, elsewhere and in other shapes
/// of the same triangles, as the fish of a school and the valves of a clam are.
bool is_same_swarm(const Model& a, const Model& b);

/// The organs of a swarm in about so many triangles, carried to where they are at the scene's keys but the
/// last.
std::map<std::string, std::vector<ExportPart>> swarm_parts(Maker& maker, const Look& look, const Model& last,
                                                           std::span<const Model> keys, double triangles);

}  // namespace frond
