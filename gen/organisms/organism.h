#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/vec.h"
#include "organisms/grower.h"
#include "organisms/sowing.h"
#include "world/style.h"

namespace frond {

/// Where the organisms of one entry stand: the first at given places, the others scattered in a ring round a
/// centre.
struct Place {
  std::vector<Vec2> at;         ///< x, z in metres
  Vec2 center{0};               ///< x, z of the ring
  double inner = 0;             ///< metres
  double radius = 2;            ///< metres, the outer edge
  double spacing = 0.35;        ///< metres that each keeps free round itself
  double size_variation = 0.2;  ///< random change of the size, as a share of it
  double turn = 0;              ///< about the vertical
  double turn_variation = kPi;  ///< random change of the turn, either way
  double lean = radians(6.0);   ///< up to how far each leans, at random
  double raise = 0;             ///< metres above the ground
  std::vector<std::string> on;  ///< names of bodies that it stands on, for colonies; empty: on the ground
  double upright = 0.6;  ///< how upright such a one stands on a slope: 1 plumb .. 0 at right angles to it
  double rock = 0.5;     ///< metres, the width of the rock that each stands on; 0: on the bare ground
};

/// One entry of a preset's `organisms`.
struct Organism {
  std::string species;  ///< preset whose first organism it is laid over; it has been by the time it is read
  std::string name;     ///< the user's name for it, for messages and comments
  int count = 1;        ///< how many, those at given places included; never fewer than those
  Place place;
  std::optional<Sowing> sown;  ///< copies of a few models, sown over the land
  Style style;
  std::shared_ptr<const Grower> grower;  ///< its kind with its parameters; never null once it is read
  std::string text;  ///< all that its shape depends on, as it was written (canonical JSON); for hashes
};

}  // namespace frond
