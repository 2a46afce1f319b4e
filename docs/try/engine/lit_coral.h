#pragma once

#include <vector>

#include "appearance/appearance.h"
#include "model/model.h"

namespace frond {

/// A coral as the page draws it: numbers for WebGL. Openness is the share, 0..1, of what comes from all sides
/// that its own shape lets through.
struct LitCoral {
  std::vector<float> segments;         ///< 13 each: x, y, z and radius of both ends, colour, 1, openness
  std::vector<float> places, normals;  ///< of the vertices of its bodies, 3 each
  std::vector<float> skin;             ///< 3 each: ridge (1) or hollow (0), share of youth, openness
  std::vector<std::uint32_t> corners;  ///< of triangles
  std::vector<float> ground;           ///< openness of a square of ground, twice, row by row
  float ground_half = 0;               ///< metres, half the side of that square
};

/// A coral at a share of its growth, 0..1. The ground is as large as all of it asks for.
LitCoral lit_coral(const Model& model, const Look& look, float grown);

}  // namespace frond
