#include "geometry/girth.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace frond {

namespace {

/// What the end of a segment counts for in the pipe model where branches sprout: little as long as it is
/// short beside the one below it.
float sprouted(const Skeleton& s, std::size_t i) {
  std::int32_t p = s.parent[i];
  if (p == Skeleton::kRoot || s.parent[p] == Skeleton::kRoot) return 1;
  float own = s.distance[i] - s.distance[p], below = s.distance[p] - s.distance[s.parent[p]];
  return own < 0.5f * below ? std::max(2 * own / below, 1e-3f) : 1;
}

/// The radii that carry what is above them, before they are scaled to the base.
void set_pipes(Skeleton& s, float exponent, bool sprouting) {
  std::vector<float> carried(s.size(), 0);
  for (std::size_t i = s.size(); i-- > 0;) {
    // At least what it would carry as a tip.
    carried[i] = std::max(carried[i], sprouting ? sprouted(s, i) : carried[i] == 0 ? 1.0f : 0.0f);
    if (s.parent[i] != Skeleton::kRoot) carried[s.parent[i]] += carried[i];
    s.radius[i] = std::pow(carried[i], 1 / exponent);
  }
}

}  // namespace

void set_girth(Skeleton& s, const Girth& girth, float start_radius, bool sprouting) {
  if (s.size() == 0) return;
  float base = static_cast<float>(girth.radius), least = static_cast<float>(girth.least);
  if (girth.from == GirthFrom::turtle) {
    float factor = base > 0 ? base / start_radius : 1;
    for (float& radius : s.radius) radius *= factor;
  } else if (girth.from == GirthFrom::distance) {
    float longest = std::max(s.longest(), 1e-6f);
    if (base <= 0) base = start_radius;
    for (std::size_t i = 0; i < s.size(); ++i)
      s.radius[i] = base * static_cast<float>(girth.curve((s.to_tip[i]) / longest));
  } else {
    if (base <= 0) base = start_radius;
    set_pipes(s, static_cast<float>(girth.exponent), sprouting);
    float factor = base / *std::max_element(s.radius.begin(), s.radius.end());
    for (float& radius : s.radius) radius *= factor;
  }
  float foot = s.radius[0], flare = static_cast<float>(girth.flare);
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (flare > 0) s.radius[i] *= 1 + flare * (1 - smooth_step(0.0f, 4.0f * foot, s.distance[i]));
    s.radius[i] = std::max(s.radius[i], least);
  }
}

}  // namespace frond
