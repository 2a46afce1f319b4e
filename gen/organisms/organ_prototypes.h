#pragma once

#include <string_view>

#include "organisms/plant.h"

namespace frond {

/// The shapes of a plant's organs: one for each of `organs`, and last the ball and the disc that `@O` and
/// `@o` of any grammar draw.
std::vector<Prototype> organ_prototypes(const PlantParams& params);

/// Which of them stands at a site of that name; -1: none.
int prototype_of(const PlantParams& params, std::string_view symbol);

}  // namespace frond
