#pragma once

#include <cstddef>
#include <vector>

#include "core/vec.h"

namespace frond {

/// The space that a colony would fill without neighbours: it spreads from its foot at constant speed in each
/// direction, and reaches `across` sideways and `up` above when grown.
struct Claim {
  Vec3 foot{0};
  float across = 0.2f, up = 0.2f;  ///< metres, > 0
};

/// The space for which colonies compete: each point belongs to the colony that would reach it first if all
/// began together and spread as claimed (a Voronoi diagram weighted by the speed of growth, as Okabe et al.
/// 2000, 3.1.2). So no two overlap, growth does not depend on order, and the space of a removed colony
/// becomes free.
class Territories {
 public:
  Territories() = default;
  explicit Territories(std::vector<Claim> claims);

  std::size_t size() const { return claims_.size(); }
  const Claim& claim(std::size_t i) const { return claims_[i]; }
  /// The claims that bound the territory of a claim.
  const std::vector<std::size_t>& rivals(std::size_t i) const { return rivals_[i]; }

  /// A lower bound of the distance from a point to the border of the territory of claim `own`, metres;
  /// negative outside; kOpen if no other claim is near.
  float room(std::size_t own, Vec3 at) const;
  static constexpr float kOpen = 1e3f;
  /// The share of the sky, 0..1, above a point of its territory that fully grown rivals leave open, each
  /// direction weighted by its height. Their claims count as opaque.
  float sky(std::size_t own, Vec3 at) const;

 private:
  std::vector<Claim> claims_;
  std::vector<std::vector<std::size_t>> rivals_;  // of each, those whose claims may touch its own
};

}  // namespace frond
