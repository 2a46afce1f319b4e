#pragma once

#include "rocks/blob_surface.h"
#include "rocks/blobs.h"

namespace frond {

/// What time has done to a rock. All of it moves the vertices of the mesh; nothing of it changes what hangs
/// together.
struct Weathering {
  int facets = 9;             ///< planes along which pieces have broken off
  double facet_depth = 0.3;   ///< 0 none .. 1: how much has broken off
  double edge = 0.25;         ///< 0 sharp .. 1: how far the edges between facets are rounded
  double roughness = 0.35;    ///< 0 smooth .. 1: lumps, dents and grain by noise
  double strata = 0;          ///< 0 none .. 1: how far soft layers lie back behind hard ones
  double layer = 0.1;         ///< thickness of a layer, as a share of the size
  double dip = radians(8.0);  ///< of the layers, from the horizontal
  double underside = 0.3;     ///< share of the height below which it is cut flat
};

/// A rock of one piece.
struct RockShape {
  std::vector<Blob> own;  ///< its blobs; empty: random ones
  BlobChance chance;
  Falloff falloff = Falloff::gaussian;
  double level = 1;   ///< of the field at the surface, > 0
  bool lying = true;  ///< turned so that its shortest side is the upright one
  CellOptions cells{7, 0.0003};
  double size = 0.6;  ///< metres, the longest side before weathering, > 0
  Weathering weathering;
};

/// The blobs of a rock: its own, or random ones, drawn until they make one piece (the first of them where
/// they never do), and turned as it lies.
Blobs rock_blobs(const RockShape& shape, Seed seed);

/// The implicit surface of its blobs in metres, without weathering: its foot, the middle of its lowest level,
/// at the origin. Empty where nothing is inside.
Surface bare_rock(const RockShape& shape, const Blobs& blobs);

/// The same for a renderer that knows implicit surfaces.
Isosurface native_rock(const RockShape& shape, const Blobs& blobs);

/// The whole rock: bare, broken, layered, worn and cut flat below. It stands on y = 0, its foot at the
/// origin.
Surface rock_surface(const RockShape& shape, Seed seed);

/// How many pieces a mesh is in.
int count_pieces(const Surface& surface);

}  // namespace frond
