#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/seed.h"
#include "model/surface.h"

// Snow that lies: where, and how deep.

namespace frond {

/// Share of the snow that stays on a face whose normal rises by `up`, the cosine of its slope: all of it up
/// to 30 degrees, none from 55 degrees on, where it slides off (McClung and Schaerer, The Avalanche
/// Handbook).
double lying_share(double up);

/// What the wind does with falling snow.
struct SnowWind {
  Vec2 toward{1, 0};  ///< x and z, of length 1
  double drift = 0;   ///< 0 calm .. 1: how much of the snow is carried from windward to lee
};

/// What stands in a square, seen from above: in each cell the lowest and the highest place of all faces.
class CoverGrid {
 public:
  /// The square about `center` (x, z), with its side and that of its cells; metres.
  CoverGrid(Vec2 center, float side, float cell);

  void add(const Surface& body);

  /// Share of the falling snow that comes to a place, 0..1: that of the directions which nothing blocks, from
  /// straight above to 60 degrees from there.
  float openness(Vec3 at) const;
  /// The highest place there; `none` where nothing stands.
  float top(Vec2 at, float none) const;
  /// Whether what falls to a place has met something on its way; `fall` is its velocity, which goes down.
  bool shelters(Vec3 at, Vec3 fall) const;

 private:
  bool find(Vec2 at, std::size_t& index) const;
  /// At least the highest place of all within the reach of openness().
  float highest_near(Vec2 at) const;

  Vec2 low_;
  float cell_;
  int side_;            // cells
  int block_, blocks_;  // cells of a block, blocks of the side
  std::vector<float> bottom_, top_;
  std::vector<float> highest_of_;  // the blocks
  float highest_;
};

/// A layer of snow on something. It is one mesh at any depth, so nothing pops while it grows.
struct SnowSheet {
  std::vector<Vec3> bare;    ///< metres, what it lies on
  std::vector<float> share;  ///< of the depth on open level ground, at each of these places
  std::vector<std::array<std::uint32_t, 3>> triangle;
};

/// The snow at a depth in metres. Its places rise in proportion to the depth from just below what it lies on.
Surface snow_surface(const SnowSheet& sheet, double depth);

/// Share of falling snow that comes to a place.
using OpennessAt = std::function<float(Vec3)>;

/// The snow on what of a body is seen from above, on a grid of cells of that side, metres. `depth` is the
/// largest that is asked for: edges are as round as so much snow makes them.
SnowSheet snow_on_body(const Surface& body, double depth, float cell, const OpennessAt& openness);

/// A trunk, at whose foot the snow has a hollow. Metres.
struct SnowTrunk {
  Vec2 at{0};
  float radius = 0.1f;
};

/// What of the ground snow lies on, and what lies round there.
struct SnowLand {
  std::function<double(Vec2)> height;  ///< of the ground at x, z
  Vec2 center{0};                      ///< where it is finest
  double radius = 50;                  ///< metres
  int rings = 300;                     ///< of the mesh, as of ground_surface()
  std::vector<SnowTrunk> trunks;
  std::function<double(Vec2)> kept = {};  ///< share of the depth that is left at x, z; empty: all
};

/// The snow on the ground: less below what shelters it, hollow at trunks, drifts in the lee of `bodies` and
/// none before them (Winstral and others 2002), waves of wind-blown snow between.
SnowSheet snow_on_ground(const SnowLand& land, const CoverGrid& bodies, const SnowWind& wind, Seed seed);

}  // namespace frond
