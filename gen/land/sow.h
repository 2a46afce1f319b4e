#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/assets.h"
#include "core/result.h"
#include "core/seed.h"
#include "core/vec.h"
#include "images/raster.h"
#include "land/scatter.h"

namespace frond {

/// Which of the plants that stand above each other keep apart by their crowns.
enum class Layer { canopy, shrubs, herbs };

/// Where plants of one kind come up. Edges of altitude, slope, shade and clumps are soft: toward them there
/// are fewer, beyond them none.
struct SowRules {
  Layer layer = Layer::canopy;
  double radius = 2;         ///< metres, of the crown at size 1: crowns of one layer keep apart by both radii
  double stem = 0.3;         ///< metres that plants of other layers keep free round it, at size 1
  Vec2 altitude{-1e4, 1e4};  ///< metres above the lowest of the land, lowest and highest
  double slope = 0.7;        ///< radians, steepest
  double patch = 0;          ///< metres from clump to clump; 0: evenly
  double cover = 1;          ///< share of the land that its clumps cover
  Vec2 shade{0, 1};          ///< least and most share of the sky that crowns of higher layers hide
  double clear = 0.5;        ///< metres that its foot keeps from the edge of a path
  Vec2 center{0};            ///< x, z in metres
  double reach = 0;          ///< metres round `center`; 0: all of the land
  std::string map;           ///< a PNG whose brightness is the density, laid over the land; empty: none
  Grid density;              ///< what the map holds; -x at its left, -z on top
};

/// How bright a picture is, 0 to 1; what is transparent is dark.
Grid density_of(const Raster& picture);

/// Takes the density that a PNG file holds, for properties that name one.
Errors load_density(const NamedFile& file, SowRules& rules);

/// The ground as sowing asks of it. Functions that are empty: level, nothing to keep clear of.
struct Land {
  double size = 100;                     ///< metres, side of the square about the origin that is sown
  std::function<double(Vec2)> altitude;  ///< metres above the lowest
  std::function<double(Vec2)> slope;     ///< radians
  std::function<double(Vec2)> path;      ///< metres to the edge of what is kept clear, below 0 on it
  std::vector<Spot> taken;               ///< stems keep out of these
};

/// So many plants of one kind.
struct SowOrder {
  SowRules rules;
  int count = 0;              ///< those at given places included
  double size_variation = 0;  ///< sizes are 1 by as much more or less
  int models = 1;             ///< at least 1
  std::vector<Vec2> at;       ///< where the first ones stand, whatever the rules say
  Seed seed;
};

/// A plant that came up.
struct Sprout {
  Vec2 at{0};
  float size = 1;
  std::uint16_t model = 0;  ///< another than that of the nearest of its kind, where there are two models
  Seed seed;                ///< its own
};

/// How much of the sky a crown of `radius` hides from a place on the ground so far from its stem, 0 to 1: all
/// from within, none from beyond 2.2 radii. Crowns together hide 1 - (1 - a)(1 - b)...
double hidden_sky(double distance, double radius);

/// Sows all orders together and returns what came up of each; fewer than its count where the room runs out.
/// Poisson disks by throwing darts, the canopy first, and in each layer the largest first (Lagae and Dutre
/// 2005, with a grid for each octave of radii); kinds of about one size take turns at random, so that none
/// takes the room of one that stands later in the list.
std::vector<std::vector<Sprout>> sow(std::span<const SowOrder> orders, const Land& land);

}  // namespace frond
