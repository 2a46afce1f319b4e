#pragma once

#include "model/surface.h"

namespace frond {

enum class SprigKind {
  oval,     ///< simple leaves along a twig
  lobed,    ///< the same with lobes, as on oaks
  narrow,   ///< long and narrow, as on willows
  needles,  ///< all round a twig
  feather   ///< one leaf of many leaflets, as on acacias
};

/// The leaves of a twig as one mesh of few triangles.
struct SprigShape {
  SprigKind kind = SprigKind::oval;
  int leaves = 7;               ///< or needles, or pairs of leaflets
  double leaf = 0.4;            ///< length of one, as a share of the sprig's
  double width = 0.6;           ///< of a leaf, as a share of its length
  double open = radians(55.0);  ///< between leaf and twig
  double hang = 0;              ///< 0: upper sides turned up .. 1: leaves hang down
};

/// The sprig, one unit long from its foot along +y, upper side toward +z; `uv` as on a blade, leaf by leaf.
Surface sprig_surface(const SprigShape& shape);

}  // namespace frond
