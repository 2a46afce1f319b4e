#pragma once

#include "organisms/stone_look.h"

namespace frond {

/// Many small ones that lie about.
struct PebblesParams {
  RockShape shape;  ///< of each but for its size
  StoneLook stone;
  int shapes = 8;            ///< different ones; each lies in many places, turned and sized at random
  int number = 150;          ///< fewer where there is no room
  double radius = 1.2;       ///< metres of the field
  double inner = 0;          ///< metres round its middle that stay free
  double least_size = 0.03;  ///< metres, the longest side; small ones are more frequent
  double most_size = 0.12;
  double buried = 0.25;  ///< share of the height that is in the ground

  PebblesParams();
};

/// Lays a field of pebbles round the origin. Each follows the ground below it.
Result<Model> build_pebbles(const PebblesParams& params, Seed seed);

/// The faults of a shape without an inside, and of ranges upside down.
Errors check_pebbles(const PebblesParams& params);

}  // namespace frond
