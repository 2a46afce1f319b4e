#pragma once

#include "rocks/blob_surface.h"
#include "rocks/blobs.h"
#include "rocks/framework.h"

namespace frond {

/// Weathering of a rock. It only moves vertices of the mesh and never changes its connectivity.
struct Weathering {
  int facets = 9;             ///< number of planes along which pieces have broken off
  double facet_depth = 0.3;   ///< 0 none .. 1: amount broken off
  double edge = 0.25;         ///< 0 sharp .. 1: rounding of the edges between facets
  double roughness = 0.35;    ///< 0 smooth .. 1: lumps, dents and grain by noise
  double strata = 0;          ///< 0 none .. 1: depth of soft layers behind hard ones
  double layer = 0.1;         ///< thickness of a layer, as a share of the size
  double dip = radians(8.0);  ///< of the layers, from the horizontal
  double underside = 0.3;     ///< share of the height below which it is cut flat
};

/// What a rock is made as.
enum class RockForm { blobs, framework, rubble };

/// A rock of one piece.
struct RockShape {
  RockForm form = RockForm::blobs;
  Framework framework;    ///< of the other two forms, which have no blobs and no weathering
  std::vector<Blob> own;  ///< its own blobs; empty: random ones
  BlobChance chance;
  Falloff falloff = Falloff::gaussian;
  double level = 1;   ///< of the field at the surface, > 0
  bool lying = true;  ///< rotated so that its shortest side is vertical
  CellOptions cells{7, 0.0003};
  double size = 0.6;  ///< metres, the longest side before weathering, > 0
  Weathering weathering;
};

/// The blobs of a rock: its own, or random ones, redrawn until they form one piece (the first try if they
/// never do), rotated as it lies.
Blobs rock_blobs(const RockShape& shape, Seed seed);

/// The implicit surface of a rock's blobs as a mesh in metres, without weathering: its foot, the middle of
/// its lowest level, is at the origin. Empty if there is no inside.
Surface bare_rock(const RockShape& shape, const Blobs& blobs);

/// The surface of bare_rock() for renderers that support implicit surfaces.
Isosurface native_rock(const RockShape& shape, const Blobs& blobs);

/// The finished rock: broken, layered, worn and cut flat below. It stands on y = 0, its foot at the origin.
Surface rock_surface(const RockShape& shape, Seed seed);

/// Number of connected pieces of a mesh.
int count_pieces(const Surface& surface);

}  // namespace frond
