#pragma once

#include <algorithm>
#include <vector>

#include "core/seed.h"
#include "crown/weber_penn.h"

// The stems of weber_penn.cpp before they become branches.

namespace frond {

using DQuat = glm::dquat;

// A stem's rotation starts from growing along +y.
inline DQuat about_x(double angle) { return glm::angleAxis(angle, DVec3(1, 0, 0)); }
inline DQuat about_y(double angle) { return glm::angleAxis(angle, DVec3(0, 1, 0)); }
inline DVec3 heading(const DQuat& turn) { return turn * DVec3(0, 1, 0); }

inline double vary(double mean, double spread, Seed seed) { return mean + spread * seed.range(-1, 1); }

inline constexpr std::size_t kMostNodes = 4'000'000;  // of a tree

/// A stem before it is built.
struct Stem {
  int level = 0;
  double length = 0, radius = 0;  // radius at its foot
  double share = 1;               // of the greatest length that its parent allows
  double offset = 0;              // position on its parent, 0..1
  DVec3 foot{0};
  DQuat turn{1, 0, 0, 0};
  std::int32_t below = Skeleton::kRoot;
  Seed seed;
};

/// A stem, or a clone of it from its split to its tip, as points at the ends of the segments.
struct StemChain {
  int first = 0;  // its first segment
  int from = -1;  // the chain that it splits off
  std::vector<DVec3> at;
  std::vector<DQuat> turn;    // of the segment above each point; the last one is repeated
  std::vector<double> share;  // share of the child stems that an unsplit stem would have there, by segment

  double place(double s) const { return std::clamp(s - first, 0.0, static_cast<double>(at.size() - 1)); }

  /// Point at `s` segments from the stem's foot, on a Catmull-Rom curve.
  DVec3 point(double s) const;

  /// Rotation of the stem there.
  DQuat frame(double s) const;
};

/// The trunk along the axes of guides, as many segments as a trunk has; what forks off is a clone.
std::vector<StemChain> guided_trunk(const WeberPenn& tree, const std::vector<GuideAxis>& axes);

/// A stem and its clones as points; the first is the stem itself. `left` carries the rounding error of the
/// number of splits from stem to stem of a level, within -0.5..0.5. It bends aside where the detour asks.
/// None if there would be more than kMostNodes points.
std::vector<StemChain> trace_stem(const WeberPenn& tree, const Stem& stem, double& left,
                                  const Detour& detour = {});

}  // namespace frond
