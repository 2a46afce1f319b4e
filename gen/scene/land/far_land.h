#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/seed.h"
#include "core/vec.h"
#include "land/mountain_cover.h"

namespace frond {

/// The land beyond the ground that is laid, as far as the horizon: hills, fields in parcels, woods, villages
/// and, where there are some, mountains. The earth's curvature is left out: it hides 1 m at 3.6 km and 11 m
/// at 12 km.
struct FarLandShape {
  double reach = 12000;              ///< metres from the middle to the horizon
  double relief = 70;                ///< metres, from valleys to hilltops
  double hill_size = 1500;           ///< metres from hill to hill
  double parcel = 130;               ///< metres, mean width of fields; they are twice as long
  double fields = 0.5;               ///< share of the open land that is ploughed, 0..1; the rest is grass
  double woods = 0.3;                ///< share of the land, 0..1
  double hedges = 0.35;              ///< share of the borders between parcels that have one, 0..1
  double villages = 900;             ///< metres from one to the next along a road; 0: none
  double mountains = 0;              ///< metres, height of mountains above the hills
  double mountains_distance = 6000;  ///< metres from the middle to where they have risen
  double tree_line = 1800;           ///< metres above the middle, the highest woods
  double snow_line = 1e5;            ///< metres above the middle, the lowest snow
  /// Names of the organisms that trees are drawn as: the first where conifers stand, else one of the others;
  /// none: plain trees.
  std::vector<std::string> trees;
  Vec2 shaded{0};  ///< direction of the side that sees least of the sun, as the setting says

  AltitudeLines lines() const { return {tree_line, snow_line, shaded}; }
};

/// Where the ground that is laid ends and the far land begins.
struct GroundEdge {
  double radius = 0;    ///< metres from the middle to the edge; 0: no land goes on behind it
  bool square = false;  ///< a square about the middle rather than a disc
  bool country = true;  ///< whether there is far land where a preset says nothing of it
  std::function<double(Vec2)> beyond = {};  ///< height with which it ends, past the edge; none: 0

  /// Metres to the edge, negative within.
  double outside(Vec2 at) const;
};

/// What covers a piece of the land. All that mountain_cover_at() tells apart is one.
enum class FarCover : std::uint8_t { meadow, hay, pasture, wheat, barley, rape, earth, wood, mountain };
inline constexpr int kFarCovers = 9;

/// A field, meadow or piece of wood.
struct Parcel {
  Seed seed;            ///< its own
  Vec2 site{0};         ///< a place within
  Vec2 next{0};         ///< that of the nearest neighbour
  double edge = 0;      ///< metres to the border with that
  Seed border;          ///< of that border, the same from both sides
  bool across = false;  ///< whether it is ploughed across the main direction
};

/// The far land as functions of the place: of the shape, the seed and where the near ground ends.
class FarLand {
 public:
  FarLand(const FarLandShape& shape, const GroundEdge& edge, Seed seed);

  const FarLandShape& shape() const { return shape_; }
  const GroundEdge& edge() const { return edge_; }

  /// The height at a place, metres; at the edge the height and slope of the near ground. Details that lines
  /// `spacing` metres apart cannot show are left out.
  double height(Vec2 at, double spacing = 0) const;
  /// The slope at a place, rise over run along x and z, seen over `spacing` metres.
  Vec2 slope(Vec2 at, double spacing) const;

  /// Parcels are Voronoi cells of sites that lie in rows along the main direction.
  Parcel parcel(Vec2 at) const;
  bool wooded(const Parcel& parcel) const;
  /// A mountain is what lies above the tree line or is steep and high.
  FarCover cover(Vec2 at, const Parcel& parcel, double height, Vec2 slope) const;

  /// The main direction of parcels and roads, of length 1.
  Vec2 along() const { return along_; }
  /// Places in the middle of roads where villages are, and the direction of the road there.
  struct Village {
    Vec2 at{0}, along{1, 0};
    Seed seed;
  };
  const std::vector<Village>& villages() const { return villages_; }

 private:
  Vec2 turned(Vec2 at) const;    // into the frame of parcels
  Vec2 unturned(Vec2 at) const;  // and back
  double wood_noise(Vec2 at) const;
  void found_villages();

  FarLandShape shape_;
  GroundEdge edge_;
  Seed seed_;
  Vec2 along_{1, 0};
  double wood_from_ = 0;  // value of the noise above which parcels are wooded
  std::vector<Village> villages_;
};

}  // namespace frond
