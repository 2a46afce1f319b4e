#pragma once

#include "model/surface.h"

namespace frond {

enum class FruitForm { round, drop, pod, winged, cone, spiny, acorn };

/// A fruit one unit long: its stalk at the origin, +y toward its tip. Bodies have `uv`, see lay_sunward().
struct FruitParts {
  Surface body;
  Surface cup;  ///< of an acorn; empty otherwise
};

/// `width`: as a share of the length.
FruitParts fruit_parts(FruitForm form, double width);

/// Gives a body about +y texture coordinates that have no seam: u from the side that looks away from +z, 0,
/// to that which looks toward it, 1; v along it.
void lay_sunward(Surface& body);

/// A stalk one unit long and wide from the origin along +y.
Surface stalk_surface();

}  // namespace frond
