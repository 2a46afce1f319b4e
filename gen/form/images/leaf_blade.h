#pragma once

#include <vector>

#include "core/vec.h"
#include "images/leaf.h"

namespace frond {

/// The radius of a blade at an angle from its tip, -pi..pi, in the outline's own unit.
double leaf_radius(const LeafOutline& outline, double angle);

/// A blade in the unit of its leaf: the foot of the stalk at the origin, the tip at (0, 1). All of its rim is
/// visible from its middle.
class Lamina {
 public:
  explicit Lamina(const LeafOutline& outline);

  /// How far from the middle, 1 on the rim.
  double out(Vec2 p) const;
  bool holds(Vec2 p, double margin = 0) const { return out(p) <= 1 - margin; }
  /// Whether the straight way between two points of the blade lies in it.
  bool holds_way(Vec2 from, Vec2 to) const;
  /// The point at a share of the way from the middle to the rim; `angle` from the tip, to the right.
  Vec2 at(double angle, double share = 1) const;

  Vec2 middle() const { return {0, static_cast<float>(middle_)}; }
  /// Where the stalk ends and the blade begins.
  Vec2 foot() const { return foot_; }
  /// What the radius 1 of the outline is here.
  double scale() const { return scale_; }
  /// Bounds of the blade: x of -wide..wide.
  float wide() const { return wide_; }
  float low() const { return low_; }
  float high() const { return high_; }

 private:
  double radius(double angle) const;

  std::vector<float> radii_;  // from the tip to the stalk at equal angles
  double middle_ = 0.5, scale_ = 1, width_ = 1;
  Vec2 foot_{0};
  float wide_ = 0, low_ = 0, high_ = 1;
};

/// A lobe or a tooth of the right half of a rim.
struct RimTip {
  double angle = 0;       ///< from the tip of the leaf, as seen from the middle of the blade
  double radius = 0;      ///< there, in the outline's own unit
  double prominence = 0;  ///< how far it stands out of the notches beside it
};

/// Those of at least a prominence, from the tip to the stalk.
std::vector<RimTip> rim_tips(const LeafOutline& outline, double least);

}  // namespace frond
