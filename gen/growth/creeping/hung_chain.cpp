#include "creeping/hung_chain.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace frond {

namespace {

constexpr double kDamping = 0.35;  // share of the velocity lost in a second by friction within
constexpr double kHeld = 0.002;    // how much of the correction of a link goes to a node without room

/// The tension of each link by what hangs below it, divided by the weight of a metre. Where both ends are
/// held, the force at the lower one is that with which the links, as they lie, are closest to balance.
std::vector<double> tensions(const std::vector<DVec3>& along, const std::vector<double>& mass, bool bridged) {
  std::size_t n = along.size();
  std::vector<DVec3> pull(n, DVec3(0));
  DVec3 sum(0);
  for (std::size_t i = n; i-- > 0;) {
    if (i < mass.size()) sum.y -= mass[i];
    pull[i] = sum;
  }
  if (bridged) {
    glm::dmat3 across(1e-6);
    DVec3 rest(0);
    for (std::size_t i = 0; i < n; ++i) {
      glm::dmat3 project = glm::dmat3(1) - glm::outerProduct(along[i], along[i]);
      across += project;
      rest -= project * pull[i];
    }
    DVec3 end = glm::inverse(across) * rest;
    for (DVec3& p : pull) p += end;
  }
  std::vector<double> tension(n);
  for (std::size_t i = 0; i < n; ++i) tension[i] = std::max(glm::dot(pull[i], along[i]), 0.0);
  return tension;
}

}  // namespace

HungChain::HungChain(HungStrand rest, double step) : rest_(std::move(rest)), step_(step), at_(rest_.place) {
  assert(!at_.empty() && step > 0 && (rest_.room.empty() || rest_.room.size() == at_.size()));
  std::size_t n = at_.size();
  DVec3 above = rest_.root;
  auto add_link = [&](const DVec3& to) {
    double length = glm::distance(above, to);
    length_.push_back(std::max(length, 1e-6));
    along_.push_back(length > 1e-6 ? (to - above) / length : DVec3(0, -1, 0));
    above = to;
  };
  for (const DVec3& place : at_) add_link(place);
  if (rest_.end) add_link(*rest_.end);
  for (std::size_t i = 0; i < n; ++i)
    mass_.push_back(0.5 * (length_[i] + (i + 1 < length_.size() ? length_[i + 1] : 0)));
  velocity_.assign(n, DVec3(0));
  next_ = at_;
  weight_.resize(n);
  fault_.resize(length_.size());
  upper_.resize(length_.size());
  factor();
}

/// The matrix of mass and of the squared step times that of bending and tension, as L D L^T.
void HungChain::factor() {
  std::size_t n = at_.size();
  pivot_ = mass_;
  one_.assign(n, 0);
  two_.assign(n, 0);
  // A spring on a weighted sum of the displacements of a node and of the two before it.
  auto add = [&](std::size_t last, double stiffness, const std::array<double, 3>& factor) {
    for (std::size_t a = 0; a < 3 && a <= last; ++a) {
      std::size_t i = last - a;
      if (i >= n) continue;
      double pull = step_ * step_ * stiffness * factor[a];
      pivot_[i] += pull * factor[a];
      if (a < 2 && i >= 1) one_[i] += pull * factor[a + 1];
      if (a == 0 && i >= 2) two_[i] += pull * factor[2];
    }
  };
  double bending = kGravity * std::pow(rest_.stiffness, 3);
  std::vector<double> tension = tensions(along_, mass_, rest_.end.has_value());
  if (rest_.heading) add(0, bending / (0.5 * length_[0]), {1 / length_[0], 0, 0});
  for (std::size_t i = 0; i < length_.size(); ++i) {
    add(i, kGravity * tension[i] / length_[i], {1, -1, 0});
    if (i == 0) continue;
    double before = 1 / length_[i - 1], after = 1 / length_[i];
    add(i, bending / (0.5 * (length_[i - 1] + length_[i])), {after, -before - after, before});
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (i >= 2) {
      one_[i] -= two_[i] * one_[i - 1];
      two_[i] /= pivot_[i - 2];
    }
    if (i >= 1) {
      double side = one_[i];
      one_[i] /= pivot_[i - 1];
      pivot_[i] -= one_[i] * side;
    }
    if (i >= 2) pivot_[i] -= two_[i] * two_[i] * pivot_[i - 2];
    assert(pivot_[i] > 0);
  }
}

/// Replaces `next_`, as momentum and force, by the displacements that they bring.
void HungChain::solve() {
  std::size_t n = next_.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (i >= 1) next_[i] -= one_[i] * next_[i - 1];
    if (i >= 2) next_[i] -= two_[i] * next_[i - 2];
  }
  for (std::size_t i = n; i-- > 0;) {
    next_[i] /= pivot_[i];
    if (i + 1 < n) next_[i] -= one_[i + 1] * next_[i + 1];
    if (i + 2 < n) next_[i] -= two_[i + 2] * next_[i + 2];
  }
}

/// One step of Newton's method toward links of their lengths.
void HungChain::keep_lengths() {
  std::size_t n = next_.size(), links = length_.size();
  double pivot = 1;
  for (std::size_t i = 0; i < links; ++i) {
    DVec3 link = (i < n ? next_[i] : *rest_.end) - (i == 0 ? rest_.root : next_[i - 1]);
    double length = glm::length(link), below = i < n ? weight_[i] : 0, above = i > 0 ? weight_[i - 1] : 0;
    if (length > 0) along_[i] = link / length;
    // Links that lie straight between two held ends depend on each other but for a hair of compliance.
    double own = (above + below) * (1 + 1e-6), fault = length_[i] - length;
    if (i > 0) {
      double coupling = -above * glm::dot(along_[i - 1], along_[i]);
      upper_[i - 1] = coupling / pivot;
      own -= coupling * upper_[i - 1];
      fault -= coupling * fault_[i - 1];
    }
    pivot = own;
    fault_[i] = fault / pivot;
  }
  for (std::size_t i = links - 1; i-- > 0;) fault_[i] -= upper_[i] * fault_[i + 1];
  for (std::size_t i = 0; i < n; ++i) {
    DVec3 push = fault_[i] * along_[i];
    if (i + 1 < links) push -= fault_[i + 1] * along_[i + 1];
    next_[i] += weight_[i] * push;
  }
}

/// Puts back what has moved farther than it has room, and holds it there. True where there was any.
bool HungChain::keep_room() {
  bool any = false;
  for (std::size_t i = 0; i < rest_.room.size(); ++i) {
    DVec3 off = next_[i] - rest_.place[i];
    double far = glm::length(off);
    if (far <= rest_.room[i]) continue;
    next_[i] = rest_.place[i] + off * (rest_.room[i] / far);
    weight_[i] = kHeld / mass_[i];
    any = true;
  }
  return any;
}

void HungChain::advance(const DVec3& air) {
  std::size_t n = at_.size();
  const double drag = kGravity / (kFall * kFall);
  for (std::size_t i = 0; i < n; ++i) {
    DVec3 off = at_[i] - rest_.place[i], past = air - velocity_[i];
    // Air is slower near what is in its way.
    if (!rest_.room.empty())
      past -= air * std::min(glm::dot(off, off) / (rest_.room[i] * rest_.room[i] + 1e-12), 1.0);
    double share = drag * glm::length(past) * step_;
    DVec3 gone = velocity_[i] * (1 - kDamping * step_) + past * (share / (1 + share));
    next_[i] = mass_[i] * (off + gone * step_);
    weight_[i] = 1 / mass_[i];
  }
  solve();
  for (std::size_t i = 0; i < n; ++i) next_[i] += rest_.place[i];
  keep_lengths();
  keep_lengths();
  for (int round = 0; round < 8 && keep_room(); ++round) keep_lengths();
  for (std::size_t i = 0; i < n; ++i) {
    velocity_[i] = (next_[i] - at_[i]) / step_;
    at_[i] = next_[i];
  }
}

}  // namespace frond
