#pragma once

#include <string_view>

#include "foliage/foliage_shapes.h"
#include "organisms/plant/plant.h"

namespace frond {

/// The shapes of a plant's organs: one or more for each of `organs`, then the ball and the disc of `@O` and
/// `@o`.
std::vector<Prototype> organ_prototypes(const PlantParams& params);

/// The shape of an organ that its own grammar draws, its foot at the origin, its longest way along the stem
/// one unit. A branch of a single segment is a leaflet, each outline a blade; all other segments are the
/// stem. Lots depend on `seed`. The errors of a grammar that does not compile name its rules; so do those of
/// one that cannot be drawn, or that places organs.
Result<TwigParts> drawn_foliage(const OrganParams& organ, Seed seed);

/// Why the grammar of an organ draws none: one that does not compile, or not all its variants.
Errors organ_faults(const OrganParams& organ);

/// The prototypes that may be used at a site of some name.
struct Variants {
  int organ = -1;  ///< of `organs`; -1: the ball or the disc
  int first = -1;  ///< -1: none
  int count =
      1;  ///< consecutive prototypes; of a diagram its stages, for each of its pieces; 0: an inflorescence
  int pieces = 0;  ///< of a diagram, all of which stand together
};
Variants variants_of(const PlantParams& params, std::string_view symbol);

/// The prototypes that stand together at a site of that stage: one, from which on those follow that may stand
/// in its place, or the pieces of a flower.
std::vector<int> prototypes_at(const PlantParams& params, const Variants& variants, double stage);

}  // namespace frond
