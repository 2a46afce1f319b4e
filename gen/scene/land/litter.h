#pragma once

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// What lies on a piece of forest floor. Metres.
struct LitterShape {
  double side = 0.4;    ///< of the covered square about the origin
  double leaf = 0.08;   ///< length of a fallen leaf
  double leaves = 460;  ///< per square metre
  double twigs = 7;     ///< per square metre
  double twig = 0.16;   ///< length of one
};

/// Fallen leaves, curled and lying on top of each other, and twigs among them. `uv` is (n + u, v): n is an
/// integer per item, 0..63 for leaves and 64..127 for twigs, u runs from foot to tip and v across.
Surface litter_surface(const LitterShape& shape, Seed seed);

/// One such leaf about the origin, curled, of that length in metres.
Surface leaf_surface(double length, Seed seed);

/// A cushion of moss: a low round dome of short shoots, `side` metres wide, thin at its rim. `uv`: u from
/// foot to tip, v a random number per shoot.
Surface moss_surface(double side, Seed seed);

}  // namespace frond
