#pragma once

#include "creeping/crawl.h"
#include "creeping/crowd.h"
#include "creeping/hang.h"
#include "creeping/tread.h"

namespace frond {

/// A node as it is laid down.
struct Laid {
  Tread tread;
  double time = 0;   ///< steps since all began
  double along = 0;  ///< metres along the strand
  bool hanging = false;
  bool bud = false;  ///< a branch starts here
};

/// The growing end of a strand. It reads the host and the crowd and changes only itself.
struct Tip {
  std::int32_t strand = 0, parent = -1;
  int depth = 0;
  Seed seed;
  Tread tread;
  double along = 0;     ///< metres grown
  double next_bud = 0;  ///< metres along at which the next branch is due
  double calm = 0;      ///< metres since the last edge
  bool under = false;   ///< an overhang
  int buds = 0;         ///< that were due so far
  int branches = 0;     ///< that were tried so far
  int blocked = 0;      ///< steps without room, on end
  bool alive = true;
  bool hangs = false;
  End end = End::age;
  Chain chain;
  std::vector<std::int32_t> own;   ///< nodes that hold, where strands heed each other
  std::vector<std::int32_t> hung;  ///< nodes of the chain
  std::vector<Laid> laid;          ///< in the last step
  std::vector<DVec3> near;         ///< whom it saw in the last step
  bool gripped = false;            ///< in the last step, after hanging
};

/// How far off the surface strands creep: the radius of the youngest, the thinnest that there is.
inline double lift_of(const Crawl& crawl) { return 0.1 * crawl.radius; }

/// A tip that begins at a tread.
Tip sprout(const Tread& tread, const Crawl& crawl, Seed seed);

/// One step of a tip, the `step`th (from 0) of all. The ground must outlive the tip.
void advance(Tip& tip, const Host& host, const GroundHeight& ground, const Crowd* crowd, const Crawl& crawl,
             int step);

/// A heading near the one that is asked for in which there is room; nothing where there is none. `near` is
/// overwritten.
std::optional<DVec3> heading_with_room(const Crowd& crowd, const Tread& tread, const DVec3& heading,
                                       const Crowd::Own& own, double step, std::vector<DVec3>& near);

}  // namespace frond
