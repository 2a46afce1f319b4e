#pragma once

#include "model/surface.h"

namespace frond {

/// A classical column. Metres.
struct ColumnShape {
  double height = 3;          ///< with base and capital
  double radius = 0.21;       ///< of the shaft at its foot
  double taper = 0.84;        ///< radius at the top of the shaft as a share of that at its foot
  double entasis = 0.02;      ///< bulge of the shaft, as a share of its radius
  int flutes = 20;            ///< 0 a plain shaft; flutes with flat fillets between them
  double flute_depth = 0.45;  ///< of a half circle
  double broken = 0;          ///< 0 whole .. 0.95: share of its height that has broken off, from the top
};

/// The column as one closed body with its foot at the origin: a square plinth, the Attic base of two rolls
/// with a hollow between, the shaft, and a capital of necking, echinus and square slab. A broken one ends in
/// a rough, slanting top.
Surface column_surface(const ColumnShape& shape);

}  // namespace frond
