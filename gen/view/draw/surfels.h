#pragma once

#include <vector>

#include "light/light.h"
#include "world/specimen.h"

namespace frond {

/// How many decimals the numbers of a surfel have, and its area: what is finer does not count, and a file of
/// them holds all that there is.
inline constexpr int kSurfelDecimals = 3, kSurfelAreaDecimals = 6;

/// A bit of what a model is made of, its foot at the origin. Metres.
struct Surfel {
  Vec3 at{0};
  float area = 0;                  ///< m2, of leaves as if they lay apart
  float wide = 0;                  ///< metres of the cube that it fills
  Vec3 albedo{0};                  ///< linear
  float bulk = 0;                  ///< metres across of the bodies it is of, about; 0 of leaves
  Facing facing = kAllFacings;     ///< of the model as it was grown; known of finer ones only
  int halvings = 0;                ///< how often its cube is halved for `finer`; 0: not at all
  std::vector<Surfel> finer = {};  ///< the same surfaces, for what is too near for the whole

  bool operator==(const Surfel&) const = default;
};

/// What models of copies are made of, for each copy set those of each model; some may be empty.
using Surfels = std::vector<std::vector<std::vector<Surfel>>>;

/// A model in surfels of about a twenty-fourth of its height.
std::vector<Surfel> surfels_of(const Look& look, const Model& model);

inline constexpr int kMostHalvings = 10;

/// Finds the finer surfels of those of a model: the cube of each is halved so many times.
void refine(std::vector<Surfel>& surfels, const std::vector<int>& halvings, const Look& look,
            const Model& model);

}  // namespace frond
