#pragma once

#include <vector>

#include "dress/dress.h"
#include "model/model.h"

namespace frond {

/// The organs of a plant that look alike, as one mesh.
struct LeafPart {
  std::size_t prototype = 0, part = 0, color = 0;
  bool card = false;  ///< flat, its picture as large as the leaf's
  Surface surface;
};

/// All organs of a model where they are, in about so many triangles: leaves that have pictures become cards
/// that show these, others diamonds; if those are too many, fewer and larger ones.
std::vector<LeafPart> foliage_parts(const Look& look, Model model, double triangles);

/// A card for a leaf: flat where its mesh is on average, as large as its picture.
Surface card_of(const Surface& leaf);

}  // namespace frond
