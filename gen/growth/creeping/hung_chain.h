#pragma once

#include <optional>
#include <vector>

#include "core/vec.h"

namespace frond {

/// A hanging strand at rest, about to be moved by the air. Its weight per metre does not matter.
struct HungStrand {
  DVec3 root{0};                 ///< what holds its upper end
  std::optional<DVec3> heading;  ///< of length 1: direction in which it is clamped there; none: a hinge
  std::vector<DVec3> place;      ///< of its nodes, at rest
  std::vector<double> room;      ///< metres that each may move from there; empty: any
  std::optional<DVec3> end;      ///< what holds its lower end, if anything does
  double stiffness = 0.1;        ///< metres that it stands out before it bends under its own weight
};

/// The motion of a hanging strand: position-based dynamics (Mueller and others 2007) with links that keep
/// their length. As the links form a chain, the system of their constraints is tridiagonal and is solved
/// directly, not link by link. Bending and tension are compliant, as in the extended method (Macklin and
/// others 2016), but linear in the displacement, so they are solved exactly and implicitly, too: no stiffness
/// makes a step unstable. The tension is that of the strand at rest, and the constraints add only its
/// changes, so without wind the strand stays at rest whatever shaped it. Drag grows as the square of the
/// speed of the air; a strand that falls freely reaches kFall.
class HungChain {
 public:
  static constexpr double kFall = 3.5;  ///< metres a second, of a leafy shoot

  /// `step`: seconds of each step.
  HungChain(HungStrand rest, double step);

  /// Moves by one step in air of that velocity, metres a second.
  void advance(const DVec3& air);

  std::size_t size() const { return at_.size(); }
  const std::vector<DVec3>& places() const { return at_; }

 private:
  void factor();
  void solve();
  void keep_lengths();
  bool keep_room();

  HungStrand rest_;
  double step_;
  std::vector<double> length_;         // of the link above each node, and of the one to the end that is held
  std::vector<double> mass_, weight_;  // metres of strand, and what of its inverse counts in this step
  std::vector<DVec3> at_, velocity_, next_;
  std::vector<double> pivot_, one_, two_;  // mass and compliance, factored: a band of two to each side
  std::vector<DVec3> along_;               // of each link
  std::vector<double> fault_, upper_;      // of the system of the links' constraints
};

}  // namespace frond
