#pragma once

#include "creeping/tip.h"

namespace frond {

/// Nodes in the order in which they were laid.
struct Nodes {
  std::vector<Laid> laid;
  std::vector<std::int32_t> below;  ///< the node before it, or -1
  std::vector<std::int32_t> strand;

  std::int32_t add(const Laid& node, std::int32_t parent, std::int32_t of) {
    laid.push_back(node);
    below.push_back(parent);
    strand.push_back(of);
    return static_cast<std::int32_t>(laid.size()) - 1;
  }
};

/// Orders the nodes strand by strand, sets their radii (I5 and the pipe model of Shinozaki et al. 1964) and
/// lifts them off the surface by these. Strands without a segment are dropped.
Strands gather(const TriangleSurface& host, const GroundHeight& ground, const Nodes& nodes,
               const std::vector<Strand>& strands, const std::vector<int>& depths, const Crawl& crawl);

}  // namespace frond
