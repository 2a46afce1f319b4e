#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "appearance/condition.h"
#include "core/vec.h"
#include "land/sow.h"
#include "organisms/grower.h"
#include "pruning/edits.h"
#include "world/style.h"

namespace frond {

/// How one of several stands, besides what is said for all.
struct Stance {
  double turn = 0;  ///< radians about the vertical
  double size = 1;  ///< factor
};

/// Where the organisms of one entry stand: the first at given places, the others scattered in a ring.
struct Place {
  std::vector<Vec2> at;         ///< x, z in metres
  std::vector<Stance> each;     ///< of those at these places; the others have none of their own
  Vec2 center{0};               ///< x, z of the ring
  double inner = 0;             ///< metres
  double radius = 2;            ///< metres, the outer edge
  double spacing = 0.35;        ///< metres round each that are kept free
  double size_variation = 0.2;  ///< random change of the size, as a share
  double turn = 0;              ///< about the vertical
  double turn_variation = kPi;  ///< random change of the turn, plus or minus
  double lean = radians(6.0);   ///< largest random lean
  double raise = 0;             ///< metres above the ground
  std::vector<std::string> on;  ///< names of bodies that it stands on, for colonies; empty: on the ground
  double upright = 0.6;         ///< on a slope of such a body: 1 vertical .. 0 at right angles to it
  double rock = 0.5;            ///< metres, width of the rock below each; 0: none

  // By a plan, which also sets `at` and `each`, see scene/furnish.h:
  std::string in, along;         ///< names of its sites; empty: none
  std::vector<PlaceLine> lines;  ///< that the one at the origin is built along; empty: it stands by itself
};

/// Random colour differences between copies, plus or minus.
struct CopyTint {
  double hue = radians(4.0);  ///< radians
  double saturation = 0.1;    ///< share
  double value = 0.15;        ///< share
};

/// What a model is fitted to, metres.
struct ModelSize {
  float height = 1, crown = 1;  ///< the latter the radius within which most of it stands
  float stem = 0.1f;            ///< diameter of its foot
};

/// How a colony looks: with its tissue, white without it, or overgrown by turf.
enum class ColonyState { living, bleached, dead };

/// A few models that are grown once and placed many times over the land, as in a forest.
struct Sowing {
  int models = 6;          ///< each with its own seed
  std::vector<int> seeds;  ///< of the first models; the others get 1, 2, 3, ...
  double crowd = 0;        ///< metres: trees grow among neighbours at this distance; 0: without neighbours
  SowRules where;
  CopyTint tint;
  std::optional<ModelSize> size;  ///< that all models are fitted to; none: they are as they grow
  ColonyState state = ColonyState::living;
  double upright = 1;  ///< 1: as vertical as `place.lean` allows; 0: at right angles to the slope
  std::optional<Vec2>
      present;  ///< part of the year, 0..1, in which copies are above the ground; none: always
};

/// One entry of a preset's `organisms`.
struct Organism {
  std::string species;  ///< preset whose first organism is its base; already merged when read
  std::string name;     ///< the user's name for it, for messages and comments
  std::string group;    ///< under which lists show it; nothing grows otherwise for it
  int count = 1;        ///< number, including given places; never fewer than those
  Place place;
  std::vector<Edit> edits;     ///< of its branches by hand
  std::optional<Sowing> sown;  ///< copies of a few models, sown over the land
  Style style;
  Courses courses;                       ///< its health and its colours over the film
  std::shared_ptr<const Grower> grower;  ///< its kind with its parameters; never null after reading
};

/// The grower of an organism, whose class is known; std::bad_cast, our own mistake, where it is another.
template <class G>
const G& grower_of(const Organism& organism) {
  return dynamic_cast<const G&>(*organism.grower);
}

}  // namespace frond
