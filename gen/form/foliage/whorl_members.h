#pragma once

#include "foliage/floral_diagram.h"

// How the blades of a whorl run: the common base of meshes, of marks on them and of tests.

namespace frond {

/// How far a whorl has come at a stage of its flower.
struct Opening {
  double open = 1;    ///< 0 closed .. 1 open
  double grown = 1;   ///< factor of its length
  double wither = 0;  ///< 0 fresh .. 1 withered
};
Opening opening_of(FloralPart part, double stage);

/// A member of a whorl with all that is its own.
struct WhorlMember {
  double azimuth = 0;
  Side side = Side::side;
  double length = 1, half = 0.3;  ///< of the flower's size; half its width
  double open = 0, bend = 0, fold = 0, cup = 0;
  double foot_radius = 0, foot_height = 0;
  double outer = 0, slope = 0;  ///< by which it lies under (+1) or over (-1) the others, and tilts to a side
  double innermost = 0;         ///< 0..1, of a spiral
};

/// The members of a whorl at a stage.
std::vector<WhorlMember> members_of(const FloralDiagram& diagram, std::size_t whorl, double stage);

/// The blades of a whorl of sepals, tepals or petals at a stage. A place on a blade has the coordinates t, 0
/// foot
/// .. 1 tip, and s, -1 .. 1 from rim to rim in the sense of the azimuth. Blades are surfaces about the
/// flower's axis: what is not in the same layer as its neighbour stays clear of it.
class WhorlBlades {
 public:
  WhorlBlades(const FloralDiagram& diagram, std::size_t whorl, double stage);

  const std::vector<WhorlMember>& members() const { return members_; }
  /// The place of a point of member `k`, `above` its upper side.
  Vec3 at(std::size_t k, double t, double s, double above = 0) const;
  /// The angle about the axis from the midrib of member `k` to its rim.
  double rim_angle(std::size_t k, double t) const;

 private:
  struct Station {
    double radius, height, sine, cosine;  // of the midrib, and of its angle to the axis
  };

  void run(const WhorlMember& member, std::vector<Station>& midrib) const;
  void keep_apart();
  double place_of(int station) const;  // its t, and back; a tube ends at one
  double station_of(double t) const;
  Station station(std::size_t k, double t) const;
  double half_at(const WhorlMember& member, double t) const;
  double tube_radius(double share) const;
  double rise(const WhorlMember& member, double t, double s) const;
  double layer(double t) const;

  const Whorl& w_;
  Opening opening_;
  double fused_, sector_,
      bud_;  // share of the tube; angle of a member's share; the whorl's radius in the bud
  std::vector<WhorlMember> members_;
  std::vector<std::vector<Station>> midribs_;
  std::vector<double> apart_;  // by stations: how far layers lie from the middle one
};

}  // namespace frond
