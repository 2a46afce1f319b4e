#pragma once

#include "creeping/crawl.h"
#include "creeping/hang.h"
#include "creeping/spatial_hash.h"
#include "creeping/tread.h"

namespace frond {

/// The curves of guides, laid on a host.
class Guides {
 public:
  Guides(const TriangleSurface& host, const std::vector<CrawlGuide>& guides);

  bool empty() const { return curves_.empty(); }

  /// Which curve a strand follows, and how far along it is.
  struct Lead {
    std::int32_t curve = -1;  ///< -1: none
    std::size_t piece = 0;
  };
  /// The nearest curve within whose width a place is, or of those only the one of that number.
  Lead find(const DVec3& place, std::int32_t only = -1) const;

  /// A curve as seen from a place beside it.
  struct View {
    DVec3 along;          ///< its direction there, of length 1
    DVec3 toward;         ///< to its nearest point
    double distance = 0;  ///< metres to that point
    double width = 0;     ///< metres
    double pull = 1;      ///< of its guide
    bool ended = false;   ///< the place is past its end
  };
  /// Moves a lead along its curve to a place near the last one.
  View follow(const DVec3& place, Lead& lead) const;

 private:
  struct Curve {
    std::vector<DVec3> at;  // fewer than two where all of it is one point
    double width, pull;
  };
  View view(const Curve& curve, std::size_t piece, const DVec3& place) const;

  std::vector<Curve> curves_;
};

/// A node when it is laid.
struct Laid {
  Tread tread;
  double time = 0;   ///< steps since the start of all growth
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
  Guides::Lead lead;
  double along = 0;     ///< metres grown
  double next_bud = 0;  ///< metres along the strand where the next branch is due
  double calm = 0;      ///< metres since the last edge
  bool under = false;   ///< on an overhang
  int buds = 0;         ///< number of branches due so far
  int branches = 0;     ///< number of branches tried so far
  int blocked = 0;      ///< consecutive steps without room
  bool alive = true;
  bool hangs = false;
  End end = End::age;
  Chain chain;
  std::vector<std::int32_t> own;   ///< nodes that hold, where strands keep apart
  std::vector<std::int32_t> hung;  ///< nodes of the chain
  std::vector<Laid> laid;          ///< in the last step
  std::vector<DVec3> near;         ///< neighbours found in the last step
  bool gripped = false;            ///< took hold again in the last step, after hanging
};

/// How far off the surface strands creep: the smallest radius, that of the youngest node.
inline double lift_of(const Crawl& crawl) { return 0.1 * crawl.radius; }

/// The value of the mask at a tread; 1 without one.
inline double mask_at(const Crawl& crawl, const TriangleSurface& host, const Tread& tread) {
  return crawl.mask ? crawl.mask->at(host, tread.triangle, tread.contact) : 1;
}
/// Whether nothing may creep there: by the host itself, or by the mask.
inline bool barred(const Crawl& crawl, const TriangleSurface& host, const Tread& tread) {
  if (host.paint(tread.triangle, tread.contact).z < 0) return true;
  return crawl.mask && crawl.mask->stops > 0 && mask_at(crawl, host, tread) < crawl.mask->stops;
}
/// The distance that strands keep from each other there.
inline double spacing_at(const Crawl& crawl, const TriangleSurface& host, const Tread& tread) {
  bool scaled = crawl.mask && crawl.mask->scaling("spacing");
  return scaled ? crawl.spacing * mask_at(crawl, host, tread) : crawl.spacing;
}

/// A tip that begins at a tread.
Tip sprout(const Tread& tread, const Crawl& crawl, Seed seed);

/// What tips find as they grow.
struct CrawlWorld {
  const TriangleSurface& host;
  const GroundHeight& ground;  ///< must outlive the tips
  const Guides& guides;
};

/// Step number `step` (from 0) of a tip.
void advance(Tip& tip, const CrawlWorld& world, const SpatialHash* crowd, const Crawl& crawl, int step);

}  // namespace frond
