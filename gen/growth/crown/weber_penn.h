#pragma once

#include <array>

#include "core/detour.h"
#include "core/result.h"
#include "core/seed.h"
#include "crown/along_parent.h"
#include "crown/axes.h"
#include "crown/crown.h"

namespace frond {

/// The outline of a crown: the length of branches by their height on the trunk.
enum class CrownShape {
  conical,
  spherical,
  hemispherical,
  cylindrical,
  tapered_cylindrical,
  flame,
  inverse_conical,
  tend_flame,
  envelope  ///< that of the pruning envelope
};

/// Stems of one level: 0 the trunk, 1 its branches, and so on. A suffix `_v` marks the random variation, plus
/// or minus. Angles in radians.
struct StemLevel {
  double down_angle = 0;    ///< from the parent
  double down_angle_v = 0;  ///< negative: the angle falls by that much from the base to the top of the parent
  double rotate = 0;  ///< about the parent from one stem to the next; negative: alternating by that angle
  double rotate_v = 0;
  double branches = 0;     ///< maximum number of stems of this level on one of the level below; not of trunks
  double branch_dist = 1;  ///< 0 in whorls at its parent's segment ends .. 1 evenly; n: a whorl each n
  double length = 0.5;     ///< share of the parent's; of the trunk, of the tree's scale
  double length_v = 0;
  double taper = 1;       ///< 0 cylinder, 1 to a point, 2 with a round end, 3 a string of pearls
  double seg_splits = 0;  ///< clones that split off at the end of each segment
  double split_angle = 0;
  double split_angle_v = 0;
  int curve_res = 3;      ///< segments of a stem, > 0
  double curve = 0;       ///< over the stem, or its lower half where there is a curve_back
  double curve_back = 0;  ///< over the upper half
  double curve_v = 0;     ///< negative: the stem is a helix of that slope
  // By the place on the parent, from its foot (0) to its tip (1); not of trunks.
  Curve angle_along = even_along();     ///< factor of the angle from the parent, of leaves as well
  Curve length_along = even_along();    ///< factor of the length
  Curve radius_along = even_along();    ///< factor of the radius, which stays below the parent's
  Curve branches_along = even_along();  ///< how densely stems stand, relative to the mean
};

inline constexpr int kStemLevels = 4;

/// The envelope that branches are cut to.
struct Pruning {
  double ratio = 0;       ///< 0 no pruning .. 1 everything outside
  double width = 0.5;     ///< radius as a share of the tree's scale
  double width_peak = 0;  ///< where it is widest, as a share of its height: 0 low .. 1 high
  double power_low = 0.5, power_high = 0.5;  ///< 1 straight, below convex, above concave
};

/// The trees of Weber and Penn 1995, *Creation and Rendering of Realistic Trees*: stems of up to four levels,
/// each with its own parameters. Lengths in metres.
struct WeberPenn {
  CrownShape shape = CrownShape::conical;
  double cone_top = 0.2;    ///< length of the topmost branches of a conical crown as a share of the longest
  double base_size = 0.25;  ///< share of the trunk that is bare
  double scale = 10, scale_v = 0;     ///< size of the tree
  double z_scale = 1, z_scale_v = 0;  ///< factor of the height alone
  int levels = 3;                     ///< of stems, 1 to 9; levels beyond the fourth are like the fourth
  double ratio = 0.05;                ///< radius of the trunk as a share of its length
  double ratio_power = 1;             ///< how fast radii fall with length
  double flare = 0.5;                 ///< how much wider the foot is
  int lobes = 0;                      ///< of the trunk's cross-section
  double lobe_depth = 0;              ///< share of the radius
  double trunk_scale = 1, trunk_scale_v = 0;  ///< factor of the trunk's radius
  int base_splits = 0;                        ///< clones at the end of the trunk's first segment
  int trunks = 1;                             ///< > 0; their angles are those of level 0
  double trunk_spread = 0;                    ///< largest distance of trunks from the middle
  std::array<StemLevel, kStemLevels> level;
  double leaves = 0;  ///< on one stem of the last level; negative: as a fan at its end
  CrownShape leaf_distribution = CrownShape::tapered_cylindrical;  ///< over the level that bears it
  double leaf_scale = 0.2;                                         ///< length
  double leaf_scale_x = 0.5;                                       ///< width as a share of it
  double leaf_bend = 0.3;                                          ///< 0 as it grows .. 1 facing the light
  double leaf_stem_length = 0;                                     ///< share of the leaf's length
  double leaf_quality = 1;   ///< share of the leaves that exist; these grow larger to compensate
  double attraction_up = 0;  ///< of stems from the second level on; negative: they hang down
  Pruning pruning;
  int smoothing = 2;  ///< nodes for each segment
  /// Along which the first trunk is led, its forks as clones that split off; as long as they, not `scale`.
  GuideAxes guides = {};
  Detour detour = {};  ///< what stems bend round; what has no way on is cut off

  const StemLevel& stem(int n) const { return level[static_cast<std::size_t>(n < 3 ? n : 3)]; }
};

/// ShapeRatio of the paper: length of a branch at `ratio`, 0 at the crown's top .. 1 at its lowest branch.
double shape_ratio(CrownShape shape, double ratio, const Pruning& pruning = {}, double cone_top = 0.2);

/// Radius at `z` (0 foot .. 1 tip) of a stem with that radius and length, by its taper; without flare.
double taper_radius(double taper, double radius, double length, double z);

/// Factor by which the trunk is wider at `z` than without flare.
double flare_factor(double flare, double z);

/// Number of stems of the level above that a stem of level `n` bears: `share` is its length relative to the
/// greatest possible, `offset` its position on its parent (0 foot .. 1 tip).
double stem_count(const WeberPenn& tree, int n, double share, double offset);

/// Estimated number of nodes of a tree.
double estimate_nodes(const WeberPenn& tree);

/// Grows one tree; refused if it has more than four million nodes or ten million leaves. Radii include the
/// flare but not the lobes. After a split, a stem and its clones share the stems that it alone would have
/// borne, and each bears the leaves that it alone would have borne.
/// Differences from the paper: curve variation turns about random axes, so that stems do not lie in a plane;
/// clones after a split differ by the seed; fractions of a count are rounded randomly for the whole stem.
Result<Crown> grow_weber_penn(const WeberPenn& tree, Seed seed);

}  // namespace frond
