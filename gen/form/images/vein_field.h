#pragma once

#include "images/venation.h"

namespace frond {

/// What is seen of veins at a place of the blade.
struct VeinSight {
  double line = 0;   ///< 1 on a vein .. 0 away from it; less on fine veins
  double bulge = 1;  ///< 0 beside the larger veins .. 1 between them, where the blade bulges
};

/// Veins as a picture shows them, found by a grid.
class VeinField {
 public:
  VeinField() = default;
  /// `pixel`: the side of the largest pixel that will be asked for, in the leaf's unit.
  VeinField(const Veins& veins, double pixel);

  /// A vein finer than a pixel is drawn as wide as one and fainter, or it would break up into dots.
  VeinSight at(Vec2 p, double pixel) const;

 private:
  struct Piece {
    Vec2 from, way;
    float width, taper;  ///< half the width at `from`, and what it gains to the other end
    std::uint8_t order;
  };
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> first_, piece_;  // of each cell: where its pieces begin in the list
  Vec2 corner_{0};
  int columns_ = 0, rows_ = 0;
};

}  // namespace frond
