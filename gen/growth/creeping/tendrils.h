#pragma once

#include <cstdint>
#include <vector>

#include "core/seed.h"
#include "core/vec.h"
#include "creeping/crawl.h"

namespace frond {

/// Tendrils by which climbers hold on to thin supports, and branches with adhesive pads by which they hold on
/// to walls (Darwin 1865, The movements and habits of climbing plants). Metres.
struct Tendrils {
  int every = 1;           ///< leaves from one tendril to the next, >= 1
  double reach = 0.1;      ///< how far from its node a tendril finds a hold; its length where it finds none
  double turns = 3;        ///< round a thin support
  double coils = 4;        ///< turns of its free part to either hand
  double coil = 0.0025;    ///< radius of these turns
  double behind = 0.05;    ///< from the tip of a strand to the youngest tendril
  double radius = 0.0006;  ///< of a tendril at its foot; toward its tip it is 0.6 times as thick
  bool pads = false;       ///< whether it holds on to what is flat; if not, only to what is thin
  int branches = 5;        ///< number of short branches that end in pads
  double pad = 0.0015;     ///< radius of a pad
  double waste = 1;        ///< 0..1: share of the tendrils without a hold that are kept
  Color color{0.42f, 0.53f, 0.22f};
};

/// A node of a strand that bears a tendril, and where it turns: away from its leaf, of any length.
struct TendrilSite {
  std::int32_t node = 0;
  Vec3 aside{1, 0, 0};
};

/// What a tendril has come to.
enum class TendrilState : std::uint8_t { young, wound, padded, free };

/// A run of nodes that is a tendril or a branch of one.
struct TendrilRun {
  std::int32_t first = 0, count = 0;  ///< nodes first .. first + count - 1
  TendrilState state = TendrilState::free;
  bool branch = false;
};

/// Adds tendrils to strands, in the order of their sites, as nodes of higher orders and strands of their own;
/// nothing else of the strands changes. A tendril grows for `time`, a share of the growth > 0, from the birth
/// of its node. It is straight until then, and coils over the next four times as long. Where nothing is
/// within reach, or its node hangs, it stays free and curls up at its tip. One that would enter the host or
/// the ground is left out. The same at any number of threads.
std::vector<TendrilRun> add_tendrils(Strands& strands, const TriangleSurface& host,
                                     const std::vector<TendrilSite>& sites, const Tendrils& tendrils,
                                     double time, Seed seed, const GroundHeight& ground = {});

}  // namespace frond
