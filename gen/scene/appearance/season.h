#pragma once

#include <optional>
#include <vector>

#include "appearance/flight.h"
#include "appearance/fruiting.h"
#include "appearance/leaf_look.h"
#include "core/curve.h"
#include "core/seed.h"
#include "model/model.h"

namespace frond {

/// Flowers that grow in place of leaves.
struct Blossom {
  double share = 0.5;   ///< share of the leaf positions that bear flowers
  int cluster = 3;      ///< flowers at one place
  double size = 0.035;  ///< metres across
  int petals = 5;
  Color color{0.98f, 0.90f, 0.92f};
  Color heart{0.85f, 0.62f, 0.35f};
  double at = 0.27;     ///< time of the year at which they open
  double lasts = 0.05;  ///< years until the petals fall
};

/// When a herb's own flowers and fruits are there.
struct Flowering {
  double at = 0.3;     ///< time of the year at which they open
  double lasts = 0.1;  ///< years until they wither
};

/// The year of a tree or herb. Times of the year: 0 new year, 0.25 the first of April, 0.5 midsummer; they
/// vary between leaves. In the south everything is half a year later.
struct Seasons {
  Animated<double> at{0.5};  ///< years; the integer part is the year
  double opening = 0.29;     ///< when leaves unfold
  double turning = 0.77;     ///< when they begin to turn
  double fall = 0.85;        ///< when they fall
  double spread = 0.08;      ///< years from the first leaf to the last
  double drift = 0.02;       ///< years that a leaf falls through the air
  double litter = 0.6;       ///< share of fallen leaves that stay on the ground until spring
  bool evergreen = false;    ///< leaves stay as they are
  Color young{0.66f, 0.76f, 0.30f};
  std::vector<Color> autumn{{0.85f, 0.66f, 0.14f}, {0.80f, 0.42f, 0.10f}, {0.50f, 0.30f, 0.16f}};
  std::optional<Blossom> blossom;
  std::optional<Fruiting> fruit;
  std::optional<Flowering> flowering;  ///< of organs that are no leaves; none: they are there all year
};

/// Appends the colours of other seasons to a leaf's own; does nothing for other organs, and for leaves of
/// pictures, whose look has them: see with_seasons().
void add_seasons(Prototype& leaf, const Seasons& seasons);
LeafLook with_seasons(LeafLook look, const Seasons& seasons);

/// Appends the prototypes of the flowers and of the fruit, if there are any.
void add_seasonal(std::vector<Prototype>& prototypes, const Seasons& seasons);

/// What is wrong with the season of something with organs of these symbols, pointers below the organism's
/// own; nothing where there is none.
Errors season_faults(const std::optional<Seasons>& seasons, const std::vector<std::string>& organs = {});

/// A leaf at one moment of its life.
struct LeafState {
  float size = 0;    ///< share of its full size
  float hue = 0;     ///< -1 young .. 0 summer .. n the n-th colour of autumn
  float fallen = 0;  ///< 0 on its twig .. 1 on the ground
};
LeafState leaf_state(const Seasons& seasons, double year, Seed leaf);

/// Share of the full leaf area that is on the twigs, 0..1.
double leaf_area_share(const Seasons& seasons, double year);

/// Changes leaves in full summer state, with the prototypes made by the functions above, to their state at a
/// time in seconds: unfolded, coloured, falling, lying or gone; adds the flowers and the fruit. Smooth in
/// time; each moment is computed alone.
void in_season(Organs& organs, const std::vector<Prototype>& prototypes, const Seasons& seasons, double time,
               Seed seed, const GroundAt& ground = {});

/// Changes the leaves of a whole model to their state at a time in seconds, and adds its flowers and
/// fruit, as the other in_season() does with organs.
void in_season(Model& model, const Seasons& seasons, double time, Seed seed, const GroundAt& ground = {});

}  // namespace frond
