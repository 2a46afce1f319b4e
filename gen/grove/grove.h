#pragma once

#include <vector>

#include "core/seed.h"
#include "grove/light.h"
#include "grove/species.h"
#include "grove/wood.h"

namespace frond {

/// One tree of a grove before it grows.
struct Seedling {
  Species species;
  Vec3 foot{0};      ///< metres
  Vec3 up{0, 1, 0};  ///< the direction that it comes out of the ground in, of length 1
  Seed seed;
  int planted = 0;  ///< year of the grove in which it begins to grow
};

struct GroveOptions {
  int years = 20;
  LightLaw light;
  double wind = 22;           ///< metres a second, the strongest gust in an ordinary year
  double snow = 0;            ///< kg a square metre, the heaviest load in a year
  Seed seed;                  ///< of the weather
  bool history = false;       ///< keep what died and the rings of every year, for films
  std::vector<Shade> bodies;  ///< of walls, houses and rocks among the trees, see shades_of_body
};

/// Where a bough came off.
struct Scar {
  std::uint32_t on = 0;  ///< the internode at whose tip it stood
  Vec3 direction{0};     ///< that it grew in, of length 1
  float radius = 0;      ///< metres, when it fell
  float girth = 0;       ///< the radius of what bore it, then
  float fell = 0;        ///< year
  std::uint32_t id = 0;  ///< counts the tree's internodes as they are born: that of the bough's first
};

/// How large a tree was at the end of a year, as foresters measure it.
struct Size {
  float height = 0;           ///< metres, of what lives
  float breast_diameter = 0;  ///< metres, of the stem 1.3 m above the ground; 0 where it is not that high
  std::size_t internodes = 0;
};

/// A tree as it has grown, an entry an internode; parents precede children; entry 0 is the foot and has no
/// length. Metres and years of the grove.
struct GrownTree {
  static constexpr float kNever = 1e9f;
  static constexpr std::int32_t kRoot = -1;

  std::vector<Vec3> tip, side;
  std::vector<std::int32_t> parent;
  std::vector<float> radius;
  std::vector<float> born, died, fell;  ///< kNever where it has not happened
  std::vector<float> light;             ///< 0..1 at its buds in the last year in which it had any
  std::vector<std::uint16_t> order;     ///< 0 on the stem
  std::vector<std::uint8_t> leads;      ///< whether it bears a living terminal bud
  /// With history: the radius at the end of each year from that of birth on. Those of i are
  /// ring[first_ring[i]] .. ring[first_ring[i + 1] - 1], the first at year ceil(born[i]).
  std::vector<std::uint32_t> first_ring;
  std::vector<float> ring;

  std::vector<Scar> scars;  ///< of boughs at least five twigs thick, on what there still is
  std::vector<Size> sizes;  ///< at the end of each year since it was planted

  std::size_t grown = 0;   ///< internodes that ever grew
  std::size_t broken = 0;  ///< living branches that storms broke
  int stem_broke = -1;     ///< the first year in which a storm took more than half of the tree, or -1
  std::size_t bytes = 0;   ///< of the working state at its largest

  std::size_t size() const { return tip.size(); }
  std::size_t held() const;  ///< bytes of memory
  bool bears_leaves(const Species& species, std::size_t i, float year) const;
};

/// Grows all trees together, year by year, in one field of light: each shades the others and itself. Same
/// bytes at any number of threads.
///
/// Palubicki, Horel, Longay, Runions, Lane, Mech, Prusinkiewicz (2009): Self-organizing tree models for image
/// synthesis.
std::vector<GrownTree> grow_grove(const std::vector<Seedling>& seedlings, const GroveOptions& options);

}  // namespace frond
