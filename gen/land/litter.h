#pragma once

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// What lies on a piece of forest floor. Metres.
struct LitterShape {
  double side = 0.4;    ///< of the square about the origin in which it lies
  double leaf = 0.08;   ///< length of a fallen leaf
  double leaves = 460;  ///< on a square metre
  double twigs = 7;     ///< on a square metre
  double twig = 0.16;   ///< length of one
};

/// Fallen leaves, curled and strewn on top of each other, and twigs among them. `uv` is (n + u, v): n is a
/// whole number of each one's own, 0..63 for leaves and 64..127 for twigs, u leads from foot to tip and v
/// across.
Surface litter_surface(const LitterShape& shape, Seed seed);

/// A cushion of moss: a low dome of short shoots, `side` metres wide and round, thin at its rim. `uv`: u from
/// foot to tip, v a number of the shoot's own.
Surface moss_surface(double side, Seed seed);

}  // namespace frond
