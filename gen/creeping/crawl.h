#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/seed.h"
#include "creeping/host.h"
#include "model/skeleton.h"

namespace frond {

/// What the bias of strands is toward.
enum class Lure {
  along,  ///< a direction, everywhere the same
  light,  ///< the direction of the light, where the surface lies in shade of its own
  point,  ///< a place
};

/// How strands creep, branch, keep apart and hang. Angles in radians.
struct Crawl {
  double speed = 0.02;  ///< metres a step, > 0; every strand makes one step at a time

  double wander = 0.3;  ///< each step turns by up to so much to either side
  double bias = 0.08;   ///< 0..1 of the way to the lure, each step
  Lure lure = Lure::along;
  Vec3 toward{0, 1, 0};  ///< a direction of any length, or the place

  double branch_every = 0.25;       ///< metres along a strand, > 0
  double branch_jitter = 0.4;       ///< 0..1: by how much of that it varies
  double branch_angle = 0.5 * kPi;  ///< to either side
  int branch_depth = 4;             ///< branches of branches ...; 0 for none

  double radius = 0.003;   ///< metres, > 0: the scale of clamp(age * ripening, 0.1, 1) * scale
  double ripening = 0.05;  ///< a step
  double pipe = 2.3;       ///< a stem that carries k tips is k^(1/pipe) times as thick; 0: not at all
  double thickest = 8;     ///< times `radius` at most, >= 1

  int max_age = 400;                                            ///< steps that the whole growth takes, >= 1
  double max_length = std::numeric_limits<double>::infinity();  ///< metres of one strand
  Vec3 low{-std::numeric_limits<float>::infinity()};            ///< strands stop at the walls of this box
  Vec3 high{std::numeric_limits<float>::infinity()};
  double spacing = 0.06;  ///< metres that strands keep apart; 0: they do not heed each other
  int patience = 6;       ///< a strand stops after so many steps on which it found no room
  double waking = 0.7;    ///< 0..1: chance that a bud along a strand that has ended makes a branch after all
  std::size_t most_nodes = 4'000'000;

  bool backs = false;       ///< strands go round the rims of open meshes, to their inner sides
  double let_go = 0.1;      ///< chance that a strand loses its hold at an edge or where an overhang begins
  double hang_most = 1;     ///< metres: a hanging strand grows no longer
  double stiffness = 0.12;  ///< metres, > 0, that a strand stands out freely before its weight bends it down
};

/// Where a strand begins. A heading of length 0 is the steepest way up.
struct Start {
  DVec3 place{0};  ///< the strand begins at the nearest point of the host
  DVec3 heading{0};
};

/// Why a strand ends.
enum class End { age, length, crowded, box, hung, stuck, nodes };

/// Runs of nodes and what became of them: one entry a strand.
struct Strand {
  std::int32_t first = 0, count = 0;  ///< nodes first .. first + count - 1
  std::int32_t parent = -1;           ///< the strand that it branches off, or -1
  End end = End::age;
};

/// What has grown. The skeleton's `birth` is the time at which a node was laid down over the time of all the
/// growth; `order` is how deep the strand branches; strands are ordered by their beginning. The first node of
/// a branch is its first own one; its parent is on the strand that it leaves.
struct Strands {
  Skeleton skeleton;
  std::vector<Vec3> normal;           ///< of the surface; of hanging nodes, some direction across the strand
  std::vector<Vec3> contact;          ///< on the surface under the node; of hanging nodes, the node itself
  std::vector<float> age;             ///< steps since the node was laid down
  std::vector<std::uint8_t> hanging;  ///< 1: held by its neighbours only
  std::vector<float> room;            ///< of hanging nodes, metres from their skin to host and ground; else 0
  std::vector<std::int32_t> of;       ///< the strand of each node
  std::vector<Strand> strands;

  std::size_t size() const { return skeleton.size(); }
};

/// Grows strands over a host; no strand where there is no start. The same bytes at any number of threads.
/// Starts need not lie on the host, nor keep apart; those that lie buried within it are left out. What creeps
/// stops at the ground, what hangs lies down on it and ends; starts below it are put up to where it meets the
/// host.
Strands grow_strands(const Host& host, const std::vector<Start>& starts, const Crawl& crawl, Seed seed,
                     const GroundHeight& ground = {});

/// `count` starts along the foot of a host, about evenly spaced: where its surface is cut by the level plane
/// `above` metres over its lowest point. With `facing` (of any length but 0) only where the surface looks
/// that way. Fewer, or none, where there is no such surface.
std::vector<Start> starts_at_foot(const Host& host, int count, double above, Vec3 facing, Seed seed);

/// `count` starts strewn evenly over the surface, within `radius` metres of `centre`. Fewer, or none, where
/// there is no surface.
std::vector<Start> starts_around(const Host& host, int count, Vec3 centre, double radius, Seed seed);

}  // namespace frond
