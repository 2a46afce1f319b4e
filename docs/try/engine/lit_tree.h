#pragma once

#include <vector>

#include "organisms/tree/tree.h"

namespace frond {

/// A tree as the page draws it: numbers for WebGL. Light is a pair, 0..1 each: what the tree lets through of
/// the sun and of the sky above.
struct LitTree {
  std::vector<float> segments;             ///< 13 each: x, y, z and radius of both ends, colour, light
  std::vector<std::vector<float>> shapes;  ///< triangles of a sprig or flower: 6 a corner, place and normal
  std::vector<std::vector<float>> organs;  ///< of each shape, 13 each: place, turn, size, colour, light
  std::vector<float> ground;               ///< light on a square of ground, row by row, kGroundSide each way
  float ground_half = 0;                   ///< metres, half the side of that square
};

constexpr int kGroundSide = 65;

/// Leaves of the tree as few triangles as show their outline from some way off.
void make_few_triangles(Foliage& leaves);

/// A model of a tree with that season's leaves, shaded by itself. Shade is cast by the field of light in
/// which trees grow (grove/light.h), here turned so that light falls along `sun`, which has length 1.
LitTree lit_tree(const Model& model, const TreeParams& params, Vec3 sun);

}  // namespace frond
