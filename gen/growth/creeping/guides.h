#pragma once

#include "creeping/crawl.h"

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

}  // namespace frond
