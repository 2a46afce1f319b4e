#pragma once

#include <span>

namespace frond {

/// A leaf or a petal: a blade one unit long from its foot, folded along its midrib and bent.
struct BladeShape {
  double width = 0.45;          ///< as a share of the length
  double widest = 0.4;          ///< where along the blade, 0 foot .. 1 tip
  double fold = radians(22.0);  ///< angle by which each half is raised from the flat
  double bend = radians(40.0);  ///< from foot to tip, downward
  double stalk = 0.08;          ///< share of the length that is stalk
  double wave = 0;              ///< how much the rim is waved, 0..1
  int detail = 3;               ///< 1: 10 triangles, for masses of small leaves; 2: 52; 3: 126
  double round = 0;             ///< 0 pointed .. 1 round at its end
};

/// The blade as a mesh with `uv`: u from foot to tip, v from rim to rim with the midrib at 0.5.
Surface blade_surface(const BladeShape& shape);

/// `count` petals of that shape round the heading, in two whorls if more than eight; `open` is the angle
/// between petal and heading.
Surface corolla_surface(const BladeShape& petal, int count, double open);

/// The heart of a flower: a dome with florets by the golden angle (Vogel 1979), of that radius and flatness.
Surface heart_surface(double radius, double flatness, int florets);

/// A body of revolution about the heading, one unit long: radii from the table `profile` (0 foot .. 1 tip).
Surface turned_surface(std::span<const float> profile, int sides);

/// A ball of diameter 1 about the origin.
Surface ball_surface();

}  // namespace frond
