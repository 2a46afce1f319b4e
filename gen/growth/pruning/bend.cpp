#include "pruning/bend.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace frond {

namespace {

constexpr int kMostLoads = 400;
constexpr double kMostTurn = 0.08;   // radians at a joint by one load
constexpr double kNear = 2e-5;       // of the length: so near to the target it is there
constexpr float kWired = 1.0f / 3;   // of the thickest radius
constexpr double kDamping = 1e-3;    // of the compliance, along what cannot give way
constexpr double kStraight = 0.95;   // square of the share of its length that a straight limb reaches
constexpr double kLeastGain = 1e-4;  // of the distance to the target, by which a load has to lessen it

using DQuat = glm::dquat;

/// The force that moves the place by `error`: its compliance is the sum of c (|q|^2 - q q^T) of all joints.
DVec3 force_for(DVec3 error, std::span<const DVec3> lever, std::span<const double> compliance) {
  glm::dmat3 a(0);
  for (std::size_t k = 0; k < lever.size(); ++k) {
    const DVec3 q = lever[k];
    a += compliance[k] * (glm::dmat3(glm::dot(q, q)) - glm::outerProduct(q, q));
  }
  const double mean = (a[0][0] + a[1][1] + a[2][2]) / 3;
  if (!(mean > 0)) return DVec3(0);
  return glm::inverse(a + glm::dmat3(kDamping * mean)) * error;
}

}  // namespace

std::vector<Quat> bend_turns(std::span<const Vec3> nodes, std::span<const float> radius, float within,
                             Vec3 by) {
  const std::size_t n = radius.size();
  assert(nodes.size() == n + 1 && n > 0);
  const float thickest = *std::ranges::max_element(radius);
  std::vector<DVec3> offset(n), lever(n);
  std::vector<double> compliance(n);
  double length = 0;
  for (std::size_t k = 0; k < n; ++k) {
    offset[k] = DVec3(nodes[k + 1] - nodes[k]) * (k + 1 == n ? double{within} : 1.0);
    const double l = glm::length(offset[k]);
    compliance[k] = l / std::pow(std::max(radius[k], kWired * thickest) / thickest, 4);
    length += l;
  }
  std::vector<DQuat> turn(n, DQuat(1, 0, 0, 0));
  DVec3 target(by);
  for (const DVec3& o : offset) target += o;
  target *= std::min(1.0, length / std::max(glm::length(target), 1e-12));
  double before = HUGE_VAL;
  for (int load = 0; load < kMostLoads; ++load) {
    DVec3 place(0);
    for (std::size_t k = n; k-- > 0;) lever[k] = place += turn[k] * offset[k];
    DVec3 error = target - place;
    // A pull along a limb that is nearly straight would stretch it: no wire does that.
    const double chord2 = glm::dot(place, place), along = glm::dot(error, place);
    if (along > 0 && chord2 > kStraight * length * length) error -= place * (along / chord2);
    const double far = glm::length(error);
    if (far < kNear * length || far > before * (1 - kLeastGain)) break;
    before = far;
    const DVec3 force = force_for(error, lever, compliance);
    double most = 0;
    for (std::size_t k = 0; k < n; ++k)
      most = std::max(most, compliance[k] * glm::length(glm::cross(lever[k], force)));
    const double step = most > kMostTurn ? kMostTurn / most : 1;
    DQuat carried(1, 0, 0, 0);
    for (std::size_t k = 0; k < n; ++k) {
      const DVec3 angle = glm::cross(lever[k], force) * (compliance[k] * step);
      if (const double size = glm::length(angle); size > 1e-12)
        carried = carried * glm::angleAxis(size, angle / size);
      turn[k] = glm::normalize(carried * turn[k]);
    }
  }
  std::vector<Quat> result;
  for (const DQuat& q : turn) result.emplace_back(q);
  return result;
}

}  // namespace frond
