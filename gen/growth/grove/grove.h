#pragma once

#include <vector>

#include "core/detour.h"
#include "core/seed.h"
#include "grove/dates.h"
#include "grove/light.h"
#include "grove/species.h"
#include "grove/uproot.h"
#include "grove/wood.h"
#include "model/model.h"

namespace frond {

/// One tree of a grove before it grows.
struct Seedling {
  Species species;
  Vec3 foot{0};      ///< metres
  Vec3 up{0, 1, 0};  ///< direction in which it leaves the ground, of length 1
  Seed seed;
  int planted = 0;               ///< year of the grove in which it begins to grow
  std::vector<Vec3> guide = {};  ///< a line that its stem is led along, from the foot; metres. Empty: none
  std::string name = {};         ///< by which events name it
  std::vector<YearCut> cuts = {};
};

struct GroveOptions {
  int years = 20;
  /// Growth ends before the first year after which more internodes than so many would stand on all trees
  /// together, but not before one year has passed; 0: no limit.
  std::size_t most_internodes = 0;
  LightLaw light;
  double wind = 22;           ///< metres a second, the strongest gust in an ordinary year
  double snow = 0;            ///< kg a square metre, the heaviest load in a year
  Seed seed;                  ///< of the weather
  bool history = false;       ///< keep dead parts and the rings of every year, for films
  std::vector<Shade> bodies;  ///< of walls, houses and rocks among the trees, see shades_of_body
  Detour detour = {};         ///< round the same bodies
  Dates dates = {};           ///< what happens once
};

/// The place where a bough fell off.
struct Scar {
  std::uint32_t on = 0;  ///< the internode whose tip it was attached to
  Vec3 direction{0};     ///< in which it grew, of length 1
  float radius = 0;      ///< metres, when it fell
  float girth = 0;       ///< radius of the internode that bore it, at that time
  float fell = 0;        ///< year
  std::uint32_t id = 0;  ///< serial number, in order of birth in the tree, of the bough's first internode
};

/// The end of a limb that was sawn through.
struct SawnEnd {
  std::uint32_t on = 0;  ///< the internode that ends there
  float time = 0;        ///< year; kFresh: it is always as just sawn
  static constexpr float kFresh = -1;
};

/// The size of a tree at the end of a year, as foresters measure it.
struct Size {
  float height = 0;           ///< metres, of the living parts
  float breast_diameter = 0;  ///< metres, of the stem 1.3 m above the ground; 0 if it is lower
  std::size_t internodes = 0;
};

/// A grown tree, one entry per internode; parents precede children; entry 0 is the foot and has no length.
/// Metres and years of the grove.
struct GrownTree {
  static constexpr float kNever = 1e9f;
  static constexpr std::int32_t kRoot = -1;

  std::vector<Vec3> tip, side;
  std::vector<std::int32_t> parent;
  std::vector<float> radius;
  std::vector<float> born, died, fell;  ///< years; kNever if it has not happened
  std::vector<float> light;             ///< 0..1 at its buds in the last year with buds
  std::vector<std::uint16_t> order;     ///< 0 on the stem
  std::vector<std::uint8_t> leads;      ///< whether it bears a living terminal bud
  /// With history: the radius at the end of each year since its birth. Those of i are ring[first_ring[i]] ..
  /// ring[first_ring[i + 1] - 1], the first at year ceil(born[i]).
  std::vector<std::uint32_t> first_ring;
  std::vector<float> ring;

  Uprooting uprooting;      ///< when it has lost its balance; the tree is as it stood
  std::vector<Scar> scars;  ///< of boughs at least five twigs thick, on remaining parts
  std::vector<SawnEnd> cuts;
  std::vector<std::uint32_t> regrown;  ///< first internodes of axes that a cut has called forth, in order
  std::vector<std::string> notes;      ///< on cuts that find no branch: "/edits/2/at: finds no branch: ..."
  std::vector<AxisNode> axes;          ///< as they were before edits, see axis_nodes()
  std::vector<Size> sizes;             ///< at the end of each year since it was planted

  std::size_t grown = 0;   ///< total number of internodes ever grown
  std::size_t broken = 0;  ///< number of living branches broken by storms
  int stem_broke = -1;     ///< the first year in which a storm took more than half of the tree, or -1
  std::size_t bytes = 0;   ///< peak memory of the working state

  std::size_t size() const { return tip.size(); }
  std::size_t held() const;  ///< bytes of memory
  bool bears_leaves(const Species& species, std::size_t i, float year) const;
};

/// Grows all trees together, year by year, in one light field: each shades itself and the others. The same
/// bytes at any number of threads.
///
/// Palubicki, Horel, Longay, Runions, Lane, Mech, Prusinkiewicz (2009): Self-organizing tree models for image
/// synthesis.
std::vector<GrownTree> grow_grove(const std::vector<Seedling>& seedlings, const GroveOptions& options);

}  // namespace frond
