#pragma once

#include "core/seed.h"
#include "foliage/organ_shapes.h"
#include "model/surface.h"

namespace frond {

/// A feathered leaf, as of a palm or fern: two rows of leaflets along a rachis one unit long.
struct FrondShape {
  int pairs = 40;                ///< of leaflets
  double width = 0.45;           ///< between the tips of the longest leaflets, as a share of the length
  double stalk = 0.14;           ///< share of the length below the first leaflets
  double fold = radians(25.0);   ///< angle by which leaflets are raised from the flat: a V
  double bend = radians(70.0);   ///< of the rachis from foot to tip, downward, most toward the tip
  double droop = radians(45.0);  ///< of each leaflet from foot to tip
  int lobes = 0;                 ///< on each side of a leaflet, as on ferns; 0: leaflets are whole
};

/// A twig one unit long with leaves in two rows and one at its end.
struct TwigShape {
  BladeShape leaf;
  int leaves = 9;
  double leaf_length = 0.42;    ///< as a share of the sprig's
  double bend = radians(25.0);  ///< of the twig from foot to tip, downward
};

/// A compound leaf: its green parts, and the stalks that carry them.
struct TwigParts {
  Surface blades, stem;
};

/// The meshes of a frond; `seed` adds small irregularities. Leaflets have `uv` as a leaf has.
TwigParts frond_foliage(const FrondShape& shape, Seed seed);

/// Where a leaflet stands, and how it lies there.
struct LeafletPlace {
  Vec3 at, along, up;  ///< its foot, its direction at its foot, of length 1, and its upper side
  float length;
  double droop = 0;  ///< radians, from foot to tip
  double twist = 0;  ///< radians, about its own direction
};

/// Leaflets as those of a frond, each as wide as that share of its length; parted into `lobes` on either
/// side, if not 0.
Surface leaflets_surface(std::span<const LeafletPlace> places, double width, int lobes);

/// The meshes of a sprig.
TwigParts sprig_foliage(const TwigShape& shape, Seed seed);

}  // namespace frond
