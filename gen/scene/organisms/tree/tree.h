#pragma once

#include <span>

#include "appearance/appearance.h"
#include "core/detour.h"
#include "core/result.h"
#include "core/seed.h"
#include "foliage/sprig.h"
#include "grove/grove.h"
#include "grove/standing.h"
#include "model/model.h"
#include "motion/motion.h"
#include "organisms/tree_parts.h"
#include "pruning/edits.h"

namespace frond {

/// Appearance of a tree's leaves: sprigs at its young internodes.
struct Foliage {
  SprigShape sprig;
  std::optional<LeafLook> picture;  ///< replaces the sprig: cut along the outline of its picture
  double size = 0.28;               ///< metres, of a sprig; 0: none
  double size_variation = 0.2;      ///< random change of it, as a share
  double spread = radians(55.0);    ///< between a sprig and the shoot that bears it
  double hang = 0;                  ///< 0 held up to the light .. 1 hanging down
  std::vector<Color> colors{{0.20f, 0.34f, 0.10f}, {0.24f, 0.38f, 0.11f}, {0.28f, 0.41f, 0.13f}};
  Color second{0.45f, 0.55f, 0.25f};  ///< of the veins
};

/// How far a tree may grow, as a limit of what it costs.
struct GrowthBudget {
  int internodes = 0;  ///< that may stand on all trees that grow together; 0: as many as `seconds` allow
  double seconds = 0;  ///< of processor time; counts where internodes is 0. 0: no limit

  /// The number of internodes that it allows; 0: no limit. Seconds count by the pace of an ordinary machine,
  /// so that the result is the same on all.
  std::size_t most() const;
};

/// A tree that grows by light among all other trees of the scene.
struct TreeParams {
  int years = 32;  ///< its final age
  GrowthBudget budget;
  Species species;
  TreeGuide guide;      ///< of its stem
  BranchesAlong along;  ///< how what has grown on it is shaped
  LightLaw light;
  double wind = 22;    ///< metres a second, the strongest gust of a year
  double snow = 0;     ///< kg a square metre
  double flare = 0.7;  ///< how much wider the foot of the stem is
  int roots = 5;       ///< number of roots visible at its foot
  double knots = 1;    ///< how far stubs of shed boughs stand out; 0: none
  Foliage leaves;
  Bark bark;                     ///< of branches drawn as sweeps
  std::optional<BarkCoat> coat;  ///< where given, branches are meshes with this picture
  std::optional<Seasons> season;
  Wave wave;
  Growth growth;
};

void describe(Properties& v, TreeParams& t);

/// A tree of a grove before it grows.
struct TreeSite {
  const TreeParams* params = nullptr;
  Vec3 foot{0};
  Quat lean{1, 0, 0, 0};  ///< of its first shoot
  double age = 1;         ///< factor of its years
  Seed seed;
  std::string name = {};         ///< by which events name it
  std::vector<Edit> edits = {};  ///< of which it takes the dated ones
};

/// A grown grove: one tree per site.
struct Grove {
  int cycles = 0;  ///< number of growth cycles, see grove/age.h: of the oldest tree
  std::vector<GrownTree> trees;
};

/// Grows all trees in one field of light, shaded also by the bodies; limbs bend round what the detour tells
/// of. Light law, weather and budget are those of the first site. `history`: for films. `events` have their
/// years by the age of the oldest tree, and `toward` is where their storms blow, if it is known.
Grove grow_trees(std::span<const TreeSite> sites, bool history, Seed weather,
                 std::span<const Surface> bodies = {}, const Detour& detour = {},
                 std::span<const Event> events = {}, std::optional<Vec3> toward = {});

/// A tree at a time in cycles of the grove, at its place: branches and sprigs of leaves. After the last cycle
/// it is in the summer that follows.
Model tree_model(const TreeParams& params, const GrownTree& tree, double cycle, const Filming& filming,
                 Seed seed);

/// The height at which trees are felled, metres, at most half of their own.
inline constexpr float kStump = 0.35f;

/// Where the stem of a tree is cut, or its foot if it is not.
struct CutFace {
  Vec3 at{0};
  float height = 0;  ///< metres above the foot
};
CutFace cut_of(const Standing& now, const GrownTree& tree);

/// The growth cycles that a tree of these parameters goes through.
int cycles_of(const TreeParams& params);

/// The cycle of a grove at a time of a film; the last summer if the tree does not grow in the film.
double cycle_at(const Growth& growth, int cycles, double time);

/// Its leaves as pictures, in all seasons; they must be pictures.
LeafLook pictured_leaves(const TreeParams& params);

/// One tree by itself, its foot at the origin.
Model grow_tree(const TreeParams& params, Seed seed);

/// Nodes of a tree by light. What light leaves of it is not known before it has grown; but once it is large
/// its nodes increase by a power of its cycles, which two or three goes tell. So it is grown until then, and
/// the cycles that are left are reckoned.
double estimate_tree_nodes(const TreeParams& params, Seed seed);

}  // namespace frond
