#pragma once

#include <vector>

#include "draw/draw_list.h"

// The snow on branches as bodies of its own.

namespace frond {

/// The snow on the branches of an organism at a time, in their pose.
struct BoughSnow {
  Surface heaps;                  ///< on what is thick enough to show its shape
  Surface ridges;                 ///< on what is thinner: of three points across, without normals
  std::vector<OrganPlace> tufts;  ///< of tuft_surface(), on sprigs of needles
};

/// A heap follows the branch on its upper side, as far up and aside as heap_height() says and its load; less
/// on what is steeper than 30 degrees, none from 62 on. `pixel`: metres; what is lower than half of one is
/// left to the texture of branches.
BoughSnow bough_snow(const DrawList& drawn, double time, double pixel);

/// A tuft: 1 long from its foot along +y, half as broad as 1 to each side of x, and 1 high along +z.
Surface tuft_surface();

}  // namespace frond
