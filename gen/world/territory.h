#pragma once

#include <cstddef>
#include <vector>

#include "core/vec.h"

namespace frond {

/// What a colony would fill if it were alone: it spreads from its foot at a steady pace each way, and reaches
/// `across` to its sides and `up` above it when it is grown.
struct Claim {
  Vec3 foot{0};
  float across = 0.2f, up = 0.2f;  ///< metres, > 0
};

/// Space that colonies fight for: each place belongs to the one that would come there first, had all begun
/// together and spread as they claim (a Voronoi diagram weighted by the pace of growth, as Okabe et al. 2000,
/// 3.1.2). So no two overlap, what grows depends on no order, and where a neighbour is gone its space is
/// free.
class Territories {
 public:
  Territories() = default;
  explicit Territories(std::vector<Claim> claims);

  std::size_t size() const { return claims_.size(); }
  const Claim& claim(std::size_t i) const { return claims_[i]; }
  /// Those that bound the territory of a claim.
  const std::vector<std::size_t>& rivals(std::size_t i) const { return rivals_[i]; }

  /// At least so many metres it is from a place to the border of the territory of claim `own`; less than 0
  /// outside of it; kOpen where nobody else claims anything near.
  float room(std::size_t own, Vec3 at) const;
  static constexpr float kOpen = 1e3f;
  /// The share of the sky above a place of its territory that its rivals, grown, leave open, 0..1, each
  /// direction weighted by its height. What they claim counts as closed.
  float sky(std::size_t own, Vec3 at) const;

 private:
  std::vector<Claim> claims_;
  std::vector<std::vector<std::size_t>> rivals_;  // of each, those whose claims meet its own
};

}  // namespace frond
