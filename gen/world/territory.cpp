#include "world/territory.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

/// When the colony of a claim would be at a place, in times of its growth, and how much sooner it would be a
/// metre nearer.
struct Arrival {
  float time = 0, slope = 0;
};

Arrival arrival(const Claim& claim, Vec3 at) {
  Vec3 way = (at - claim.foot) / Vec3(claim.across, claim.up, claim.across);
  return {glm::length(way), 1 / std::min(claim.across, claim.up)};
}

}  // namespace

Territories::Territories(std::vector<Claim> claims) : claims_(std::move(claims)), rivals_(claims_.size()) {
  for (std::size_t i = 0; i < claims_.size(); ++i)
    for (std::size_t j = 0; j < claims_.size(); ++j) {
      Vec3 way = claims_[j].foot - claims_[i].foot;
      float reach =
          1.5f * (std::max(claims_[i].across, claims_[i].up) + std::max(claims_[j].across, claims_[j].up));
      if (i != j && glm::dot(way, way) < reach * reach) rivals_[i].push_back(j);
    }
}

float Territories::room(std::size_t own, Vec3 at) const {
  if (own >= claims_.size()) return kOpen;
  float least = kOpen;
  Arrival mine = arrival(claims_[own], at);
  for (std::size_t j : rivals_[own]) {
    Arrival theirs = arrival(claims_[j], at);
    least = std::min(least, (theirs.time - mine.time) / (theirs.slope + mine.slope));
  }
  return least;
}

}  // namespace frond
