#pragma once

#include <vector>

#include "dress/dress.h"
#include "model/model.h"

namespace frond {

/// The organs of a plant that look alike, as one mesh.
struct LeafPart {
  std::size_t prototype = 0, part = 0, color = 0;
  bool card = false;  ///< as large as its picture
  Surface surface;
};

/// All organs of a model where they are, in about so many triangles: leaves that have pictures become cards
/// that show these, others diamonds; if those are too many, fewer and larger ones.
std::vector<LeafPart> foliage_parts(const Look& look, Model model, double triangles);

/// A card for a leaf, as large as its picture and where its mesh is on average: flat, or of several rows that
/// bend with it.
Surface card_of(const Surface& leaf, int rows);

}  // namespace frond
