#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/mask.h"
#include "core/seed.h"
#include "core/vec.h"
#include "land/scatter.h"

namespace frond {

/// Layers of plants: only crowns of the same layer keep apart.
enum class Layer { canopy, shrubs, herbs };

/// The climate over a slope: the mean temperature of the growing season falls by 0.6 K each 100 m, and plants
/// become smaller and fewer from where it is `full` to where it is `least`. Trees end at 6.4 degrees all over
/// the world (Koerner 2012, Alpine Treelines).
struct Warmth {
  double lowest = 12;   ///< degrees Celsius, season mean at the lowest of the land
  double full = 9;      ///< down to which plants reach all of their size
  double least = 6.4;   ///< from which none comes up, below `full`
  double dwarf = 0.15;  ///< factor of their size there
};

/// Share of all plants that could stand at an altitude, metres above the lowest of the land: 1 where it is
/// warm .. 0 where it is too cold.
double warm_share(const Warmth& warmth, double altitude);

/// Straight rows, as a drill sows them and a farmer plants: plants stand in them only.
struct CropRows {
  double spacing = 0.7;  ///< metres from row to row, > 0
  double turn = 0;       ///< radians about the vertical; at 0 they run along z
  double wander = 0.03;  ///< metres that plants stand beside the middle of their row, at most
  double gaps = 0;       ///< share of the rows where nothing came up
  double gap = 0.5;      ///< metres, length of a gap, > 0
};

/// Where plants of one kind grow. Limits of altitude, slope, shade and clumps are soft: plants become fewer
/// toward them, with none beyond.
struct SowRules {
  Layer layer = Layer::canopy;
  double radius = 2;         ///< metres, of the crown at size 1: crowns of one layer keep apart by both radii
  double stem = 0.3;         ///< metres that plants of other layers keep from it, at size 1
  Vec2 altitude{-1e4, 1e4};  ///< metres above the lowest of the land, lowest and highest
  std::optional<Warmth> warmth;  ///< none: size and number do not depend on altitude
  double slope = 0.7;            ///< radians, steepest
  double patch = 0;              ///< metres from clump to clump; 0: evenly
  double cover = 1;              ///< share of the land that its clumps cover
  std::optional<CropRows> rows;  ///< none: all over the land
  Vec2 shade{0, 1};              ///< share of the sky hidden by crowns of higher layers, least and most
  double clear = 0.5;            ///< metres from its foot to the edge of a path, at least
  Vec2 center{0};                ///< x, z in metres
  double reach = 0;              ///< metres round `center`; 0: all of the land
  Mask map;                      ///< scales their density over the land
};

/// The ground for sowing. Empty functions: level, nothing to keep clear.
struct Land {
  double size = 100;                     ///< metres, side of the sown square about the origin
  std::function<double(Vec2)> altitude;  ///< metres above the lowest
  std::function<double(Vec2)> slope;     ///< radians
  std::function<double(Vec2)> path;      ///< metres to the edge of the area to keep clear, negative inside
  std::vector<Spot> taken;               ///< stems keep out of these
};

/// The plants of one kind to sow.
struct SowOrder {
  SowRules rules;
  int count = 0;              ///< including those at given positions
  double size_variation = 0;  ///< random change of the size 1, plus or minus
  int models = 1;             ///< at least 1
  std::vector<Vec2> at;       ///< positions of the first ones, regardless of the rules
  Seed seed;
};

/// A plant that was sown.
struct Sprout {
  Vec2 at{0};
  float size = 1;
  std::uint16_t model = 0;  ///< differs from that of the nearest of its kind, if there are two models
  Seed seed;                ///< its own
};

/// The size of a plant by its own seed, about 1.
double sprout_size(double size_variation, Seed own);

/// Share of the sky hidden by a crown of `radius` from a ground point at that distance from its stem, 0 to 1:
/// all within the radius, none beyond 2.2 radii. Several crowns hide 1 - (1 - a)(1 - b)...
double hidden_sky(double distance, double radius);

/// Sows all orders together and returns the plants of each; fewer than the count if there is no room. Poisson
/// disks by dart throwing, the canopy first, and in each layer the largest first (Lagae and Dutre 2005, with
/// a grid per octave of radii); kinds of similar size alternate at random, so that none is favoured by the
/// order of the list.
std::vector<std::vector<Sprout>> sow(std::span<const SowOrder> orders, const Land& land);

}  // namespace frond
