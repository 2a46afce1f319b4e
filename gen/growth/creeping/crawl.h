#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/assets.h"
#include "core/curve.h"
#include "core/mask.h"
#include "core/seed.h"
#include "core/spline.h"
#include "creeping/triangle_surface.h"
#include "model/skeleton.h"

namespace frond {

/// Toward what strands are drawn.
enum class Lure {
  along,  ///< a direction, the same everywhere
  light,  ///< the direction of the light, where the surface is in its own shade
  point,  ///< a place
  round,  ///< round what they grow on and upward, as twining plants do
};

/// Curves that strands follow, drawn on a host or near it. Each is laid on the nearest surface.
struct CrawlGuide {
  std::vector<SplinePoint<DVec3>> points;  ///< of one curve; metres, in the world
  bool curve = false;                      ///< whether it is smooth at points without handles, too
  FileName file;                           ///< of others
  std::vector<std::vector<DVec3>> filed;   ///< those of the file
  double width = 0.12;                     ///< metres to either side that strands keep within
  double pull = 1;                         ///< 0..1, how strongly they are led along it

  /// The points of each, at least two.
  std::vector<std::vector<DVec3>> curves() const {
    std::vector<std::vector<DVec3>> all = filed;
    if (points.size() > 1)
      all.push_back(spline_places(std::span<const SplinePoint<DVec3>>(points), {.smooth = curve}));
    return all;
  }
};

/// A grey, 0 to 1, that is painted on a host and scales what creeps there: 1 as everywhere, 0 nothing.
struct CrawlMask {
  /// Projected along its axis; without one, by texture coordinates. No file: the grey of the host's vertices.
  Mask picture;
  std::vector<std::string> scales{"leaves"};  ///< of kMaskScales
  double stops = 0;                           ///< strands neither begin nor go where it is below this

  bool scaling(std::string_view what) const;
  /// Its value at a point of a triangle; 1 where the host has no such paint.
  double at(const TriangleSurface& host, std::uint32_t triangle, const DVec3& point) const;
};

inline constexpr std::string_view kMaskScales[] = {"bias", "spacing", "leaves"};

/// How strands creep, branch, keep apart and hang. Angles in radians. What is animated has its keys at shares
/// of the growth, 0..1.
struct Crawl {
  double speed = 0.02;  ///< metres per step, > 0; every strand makes one step at a time

  double wander = 0.3;          ///< radians, the largest random turn per step to either side
  Animated<double> bias{0.08};  ///< 0..1, share of the turn toward the target, each step
  Lure lure = Lure::along;
  Animated<Vec3> toward{Vec3(0, 1, 0)};  ///< a direction of any length, or the place
  double pitch = radians(50.0);  ///< -pi/2..pi/2, above the level, with the lure round; below 0: left-handed
  std::vector<CrawlGuide> guides;  ///< a strand that comes within the width of one follows it to its end

  double branch_every = 0.25;       ///< metres along a strand, > 0
  double branch_jitter = 0.4;       ///< 0..1: random variation of it
  double branch_angle = 0.5 * kPi;  ///< to either side of the strand
  int branch_depth = 4;             ///< levels of branching; 0 for none

  double radius = 0.003;   ///< metres, > 0: the scale of clamp(age * ripening, 0.1, 1) * scale
  double ripening = 0.05;  ///< growth per step
  double pipe = 2.3;       ///< a stem that carries k tips is k^(1/pipe) times as thick; 0: no thickening
  double thickest = 8;     ///< maximum radius in multiples of `radius`, >= 1

  int max_age = 400;                                            ///< steps of the whole growth, >= 1
  double max_length = std::numeric_limits<double>::infinity();  ///< metres, of one strand
  Vec3 low{-std::numeric_limits<float>::infinity()};            ///< strands stop at the walls of this box
  Vec3 high{std::numeric_limits<float>::infinity()};
  double spacing = 0.06;  ///< metres that strands keep from each other; 0: they ignore each other
  int patience = 6;       ///< a strand stops after this many steps without room
  double waking = 0.7;    ///< 0..1: chance that a bud on an ended strand makes a branch after all
  std::size_t most_nodes = 4'000'000;
  /// Whether strands stay. If not, tips keep apart from each other only where they are at the same time, turn
  /// back where a strand would stop, and neither branch nor hang.
  bool trace = true;

  std::optional<CrawlMask> mask;  ///< scales bias, spacing and leaves by what is painted on the host

  bool backs = false;       ///< strands also go round the rims of open meshes to their inner sides
  double let_go = 0.1;      ///< chance that a strand lets go at an edge or where an overhang begins
  double hang_most = 1;     ///< metres, maximum length of a hanging strand
  double stiffness = 0.12;  ///< metres, > 0, that a strand stands out freely before it bends under its weight
};

/// The start of a strand. A heading of length 0 means steepest upward.
struct Start {
  DVec3 place{0};  ///< the strand begins at the nearest point of the host
  DVec3 heading{0};
  std::int32_t curve = -1;  ///< of the guides, in their order: which it follows; -1: the nearest
};

/// Why a strand ended.
enum class End { age, length, crowded, box, hung, stuck, nodes, guide };

/// A run of nodes that forms one strand, and how it ended.
struct Strand {
  std::int32_t first = 0, count = 0;  ///< nodes first .. first + count - 1
  std::int32_t parent = -1;           ///< the strand that it branches off, or -1
  End end = End::age;
};

/// The grown strands. `birth` of the skeleton is the time at which a node was laid divided by the total time;
/// `order` is the depth of branching; strands are ordered by their beginning. The first node of a branch is
/// its own; that node's parent lies on the strand it leaves.
struct Strands {
  Skeleton skeleton;
  std::vector<Vec3> normal;           ///< of the surface; of hanging nodes, some direction across the strand
  std::vector<Vec3> contact;          ///< on the surface under the node; of hanging nodes, the node itself
  std::vector<float> age;             ///< steps since the node was laid down
  std::vector<std::uint8_t> hanging;  ///< 1: held only by its neighbours
  std::vector<float> room;            ///< of hanging nodes, metres of space to host and ground; else 0
  std::vector<std::int32_t> of;       ///< the strand of each node
  std::vector<float> mask;  ///< if it scales leaves, its value at each node, 1 where it hangs; else empty
  std::vector<Strand> strands;

  std::size_t size() const { return skeleton.size(); }
};

/// Grows strands over a host; none where there is no start. The result is the same at any number of threads.
/// Starts need not lie on the host nor keep apart; those inside the host are skipped. A creeping strand stops
/// at the ground; a hanging one lies down on it and ends. Starts below the ground are moved up to where it
/// meets the host.
Strands grow_strands(const TriangleSurface& host, const std::vector<Start>& starts, const Crawl& crawl,
                     Seed seed, const GroundHeight& ground = {});

/// `count` starts along the foot of a host, about evenly spaced, where its surface is cut by a horizontal
/// plane `above` metres over its lowest point. With `facing` (any length but 0), only where the surface faces
/// that direction. Fewer, or none, where there is no such surface.
std::vector<Start> starts_at_foot(const TriangleSurface& host, int count, double above, Vec3 facing,
                                  Seed seed);

/// The beginnings of the curves of guides, and more of them along these, evenly, up to `count`.
std::vector<Start> starts_on_guides(const std::vector<CrawlGuide>& guides, int count);

/// `count` starts spread evenly over the surface within `radius` metres of `centre`. Fewer, or none, where
/// there is no surface.
std::vector<Start> starts_around(const TriangleSurface& host, int count, Vec3 centre, double radius,
                                 Seed seed);

}  // namespace frond
