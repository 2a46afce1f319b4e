#pragma once

#include <limits>
#include <map>
#include <vector>

#include "appearance/appearance.h"
#include "core/bounds.h"
#include "model/model.h"

namespace frond {

inline constexpr double kLargerLeaves = 2.1;  ///< than those of the first level, in length, at the coarser

/// How much larger than the preset's a kind of organ is drawn.
struct LeafSize {
  double edge = std::numeric_limits<double>::infinity();    ///< metres, the longest of a triangle
  double larger = std::numeric_limits<double>::infinity();  ///< factor of a card's length
};

/// The organs of a plant that look alike, as one mesh.
struct LeafPart {
  std::size_t prototype = 0, part = 0, color = 0;
  bool card = false;  ///< as large as its picture
  Surface surface;
  LeafSize size = {};  ///< what stands for an organ of this prototype
};

/// How finely organs are drawn.
struct FoliageDetail {
  double triangles = 2.5e5;                   ///< about so many of all of them, as far as `most` lets it
  bool pictures = true;                       ///< whether cards can show those of leaves
  bool moves = false;                         ///< the same organs are wanted elsewhere, vertex by vertex
  std::map<std::size_t, LeafSize> most = {};  ///< by prototype: what stands for organs is no larger
};

/// All organs of a model where they are: leaves that have pictures become cards that show these, others
/// a diamond for each piece; if those are too many, fewer and larger ones of the area of all. Without
/// pictures nothing becomes a card. What stands for others keeps within the box of all.
std::vector<LeafPart> foliage_parts(const Look& look, const Model& model, const FoliageDetail& detail);

/// How far the next levels of detail may enlarge organs that are drawn so.
std::map<std::size_t, LeafSize> most_larger(const std::vector<LeafPart>& parts);

/// A card for a leaf, as large as its picture and where its mesh is on average: flat, or of several rows that
/// bend with it.
Surface card_of(const Surface& leaf, int rows);

/// The longest edge of the triangles of a surface, metres.
double longest_edge(const Surface& surface);

/// A surface of about so many triangles and of the area that its pieces show, none of its edges longer than
/// `longest`, metres, if more triangles are needed for that.
Surface fewer_leaves(const Surface& surface, double triangles, double longest);

/// Scales each piece of a surface about its middle by a factor.
void grow_pieces(Surface& surface, float factor);

/// Moves pieces of parts into a box, and those next to its faces to touch them.
void keep_in_box(std::vector<LeafPart>& parts, const Bounds& box);

}  // namespace frond
