#pragma once

#include <vector>

#include "resolve/resolve.h"
#include "settings/scene_setup.h"

namespace frond {

/// The light that the air of a scene (SceneSetup::air) scatters from the sun toward the camera, once, and the
/// light that it takes. How far sun and sky are visible along a ray is marched against all that is traced, so
/// that crowns cast shafts and the air under them is dim. The angle by which the sun's light turns follows
/// Henyey and Greenstein (1941); above its level the air thins by a power of e.
class AirLight {
 public:
  /// For pictures of so many pixels of a frame, which must outlive this.
  AirLight(const SceneSetup& setup, double time, const TracedFrame& frame, std::array<int, 2> size);

  /// Adds it to some rows of the picture, from that one on.
  void add(LightPicture& rows, int first) const;

 private:
  /// A ray through the air, to the first surface or out of it.
  struct Way {
    Vec3 along{0};
    float metres = 0;
    float passed = 1;  ///< share of light that passes all of it
  };
  Way way(Vec3 along) const;
  /// Metres of the densest air that a way through as much has from `level_` to a height, negative below.
  double column(double height) const;
  /// Share of light that passes so many metres in a direction, and how many let that share pass.
  float passed(Vec3 along, float metres) const;
  float reached(Vec3 along, float passed) const;
  /// Shares of the places where a way scatters that see the sun, and of the sky that they see.
  Vec2 visible(const Way& way, Vec2 cell) const;
  /// The same of a pixel, from the cells around it that are about as far away.
  Vec2 visible_at(Vec2 pixel, float metres) const;

  const TracedFrame& frame_;
  std::array<int, 2> size_;
  float loss_ = 0, level_ = 0, height_ = 1, forward_ = 0;
  Vec3 sun_{0, 1, 0}, sunlight_{0}, sky_{0}, shade_{0};
  int wide_ = 0, high_ = 0;    // cells of 2 by 2 pixels
  std::vector<Vec2> visible_;  // of each cell
  std::vector<float> away_;    // metres of the ray through the middle of each
};

}  // namespace frond
