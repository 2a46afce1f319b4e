#pragma once

#include <string_view>

#include "organisms/plant/plant.h"

namespace frond {

/// The shapes of a plant's organs: one or more for each of `organs`, and last the ball and the disc that `@O`
/// and `@o` of any grammar draw.
std::vector<Prototype> organ_prototypes(const PlantParams& params);

/// Which of them may stand at a site of some name.
struct Variants {
  int organ = -1;  ///< of `organs`; -1: the ball or the disc
  int first = -1;  ///< -1: none
  int count = 1;   ///< they follow each other
};
Variants variants_of(const PlantParams& params, std::string_view symbol);

}  // namespace frond
