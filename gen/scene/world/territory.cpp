#include "world/territory.h"

#include <algorithm>

namespace frond {

namespace {

/// When the colony of a claim would be at a place, in times of its growth, and how much sooner it would be a
/// metre nearer.
struct Arrival {
  float time = 0, slope = 0;
};

Arrival arrival(const Claim& claim, Vec3 at) {
  Vec3 offset = (at - claim.foot) / Vec3(claim.across, claim.up, claim.across);
  return {glm::length(offset), 1 / std::min(claim.across, claim.up)};
}

/// Whether a ray that begins outside of what a claim covers, all of it above its foot, meets it.
bool meets(const Claim& claim, Vec3 at, Vec3 direction) {
  Vec3 size(claim.across, claim.up, claim.across);
  Vec3 from = (at - claim.foot) / size, along = direction / size;
  float toward = glm::dot(from, along);
  if (toward >= 0) return false;
  float length2 = glm::dot(along, along), away2 = glm::dot(from, from) - toward * toward / length2;
  return away2 < 1 && from.y - along.y * toward / length2 > 0;
}

}  // namespace

Territories::Territories(std::vector<Claim> claims) : claims_(std::move(claims)), rivals_(claims_.size()) {
  for (std::size_t i = 0; i < claims_.size(); ++i)
    for (std::size_t j = 0; j < claims_.size(); ++j) {
      Vec3 offset = claims_[j].foot - claims_[i].foot;
      float reach =
          1.5f * (std::max(claims_[i].across, claims_[i].up) + std::max(claims_[j].across, claims_[j].up));
      if (i != j && glm::dot(offset, offset) < reach * reach) rivals_[i].push_back(j);
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

float Territories::sky(std::size_t own, Vec3 at) const {
  if (own >= claims_.size() || rivals_[own].empty()) return 1;
  constexpr int kDirections = 32;
  int open = 0;
  for (int k = 0; k < kDirections; ++k) {
    Vec3 direction = sky_direction(k, kDirections);
    open +=
        std::ranges::none_of(rivals_[own], [&](std::size_t j) { return meets(claims_[j], at, direction); });
  }
  return static_cast<float>(open) / kDirections;
}

}  // namespace frond
