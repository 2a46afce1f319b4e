#pragma once

#include <cstdint>
#include <vector>

#include "foliage/ivy_leaf.h"
#include "foliage/mosaic.h"
#include "organisms/ivy/ivy.h"

namespace frond {

// The forms of single leaves: of each shape as many as there are petioles. A foot is at the origin, the leaf
// points along +y with its upper side toward +z. A unit is the blade of ivy; of a leaf that is a picture, the
// whole with its stalk.

inline constexpr std::uint32_t kPetioles = 6;  ///< kinds of petiole that a shape has
inline constexpr std::uint32_t kTallest = 4;   ///< the one that holds its blade farthest off

/// All forms as discs: the shapes of IvyForm, or the only one of a picture.
std::vector<LeafForm> leaf_forms(const IvyLeaves& leaves);

/// A leaf of a form; `detail` 0 from afar .. 2 near.
Surface leaf_of(const IvyLeaves& leaves, std::uint32_t form, int detail);

/// The length of a form's petiole, in units.
double stalk_of(const IvyLeaves& leaves, std::uint32_t form);

/// The same surface for feelers, which do not feel a petiole: its `uv` tell where that is.
Surface felt(const IvyLeaves& leaves, Surface leaf);

}  // namespace frond
