#pragma once

#include <string_view>
#include <vector>

#include "core/result.h"
#include "images/leaf.h"

namespace frond {

/// A photograph of a leaf that was cut out: the foot of its stalk at the bottom, in the middle of the
/// picture's width, its tip at the top. Its outline is taken from its opacity.
struct LeafPhoto {
  LeafOutline outline;         ///< the mean of both halves
  Color mean;                  ///< colour of what is opaque
  std::vector<Raster> levels;  ///< each half as large as the one before; colours go on beyond the rim
  Vec2 foot{0};                ///< end of the stalk in the first of them, pixels from its upper left corner
  double length = 1;           ///< from there to the tip, pixels

  /// The linear colour at a point of the leaf, one unit long from its foot at the origin to its tip at (0,
  /// 1), averaged over about `pixel`.
  Vec3 at(Vec2 p, double pixel) const;
};

/// Reads such a photograph, with transparency, as read_photo() does. An error says what was expected.
Result<LeafPhoto> read_leaf_photo(std::string_view bytes);

}  // namespace frond
