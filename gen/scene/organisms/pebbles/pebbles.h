#pragma once

#include "organisms/stone_look.h"

namespace frond {

/// A field of many small stones.
struct PebblesParams {
  RockShape shape;  ///< of each, except its size
  StoneLook stone;
  int shapes = 8;       ///< number of different shapes; each is used many times with random turn and size
  int number = 150;     ///< fewer if there is no room
  double radius = 1.2;  ///< metres of the field
  double inner = 0;     ///< metres round its middle that stay free
  double least_size = 0.03;  ///< metres, the longest side; small stones are more frequent
  double most_size = 0.12;
  double buried = 0.25;  ///< share of the height below the ground

  PebblesParams();
};

/// Lays a field of pebbles round the origin. Each follows the ground below it.
Result<Model> build_pebbles(const PebblesParams& params, Seed seed);

}  // namespace frond
