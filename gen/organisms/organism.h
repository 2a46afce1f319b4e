#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/result.h"
#include "grammar/forecast.h"
#include "model/model.h"
#include "organisms/bridge.h"
#include "organisms/coral.h"
#include "organisms/crown_tree.h"
#include "organisms/host.h"
#include "organisms/ivy.h"
#include "organisms/plant.h"
#include "organisms/rock.h"
#include "organisms/sowing.h"
#include "organisms/style.h"
#include "organisms/tree.h"
#include "organisms/vase.h"

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
  double rock = 0.5;            ///< metres, the width of the rock that each stands on; 0: on the bare ground
};

/// One entry of a preset's `organisms`.
struct Organism {
  std::string name;  ///< the user's name for it, for messages and comments
  int count = 1;     ///< how many, those at given places included; never fewer than those
  Place place;
  std::optional<Sowing> sown;  ///< copies of a few models, sown over the land
  Style style;
  std::variant<CoralParams, PlantParams, RockParams, PebblesParams, WallParams, ColumnParams, MeshParams,
               BridgeParams, VaseParams, WeberPennParams, ColonizedParams, TreeParams, IvyParams>
      body;
  std::string text;  ///< all that its shape depends on, as it was written (canonical JSON); for hashes
};

/// What an organism is made of at the end of its growth, with its foot at the origin. Ivy grows on others, by
/// grow_ivy().
Result<Model> grow(const Organism& organism, Seed seed);

/// How large one of them will be.
struct Foresight {
  Forecast word;     ///< of its grammar
  double nodes = 0;  ///< of its skeleton
};

/// Foresees the size without growing; a derivation past its limits is refused with the figure and the step.
Result<Foresight> foresee(const Organism& organism, Seed seed);

/// The pictures that the frames of an organism need.
std::vector<Drawing> drawings(const Organism& organism);

/// The first fault of an organism that only shows when its grammar is compiled.
Errors check(const Organism& organism);

/// What of an organism without faults is most likely not meant.
Errors doubts(const Organism& organism);

}  // namespace frond
