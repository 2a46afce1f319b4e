#pragma once

namespace frond {

/// Clear light indoors.
struct Studio {
  Color wall{0.87f, 0.86f, 0.83f};  ///< of wall and floor
  double distance = 1.5;            ///< metres from the middle of the scene to the wall behind it
  Vec3 key{-0.6f, 0.9f, 0.8f};      ///< toward the main light
  double softness = 1;              ///< of its shadows, 0 hard .. 3
};

}  // namespace frond
