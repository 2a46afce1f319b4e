#pragma once

#include "core/vec.h"

namespace frond {

/// How the gathered light is distributed among buds (Palubicki et al. 2009, section 4.3).
enum class Sharing {
  borchert_honda,  ///< at each fork in proportion to light, weighted by apical control
  priority         ///< along each axis in the order of light, the brightest first
};

/// Wood and its mechanical properties.
struct Wood {
  double exponent = 2.3;        ///< n of the pipe model, r^n = sum of r_i^n; 1.8 thick .. 3 thin trunks
  double twig_radius = 0.0025;  ///< metres, of a tip
  double density = 900;         ///< kg/m3, green
  double strength = 50e6;       ///< Pa; sound wood breaks at 40 to 60 MPa (Kane 2007)
  double stiffness = 8e9;       ///< Pa, of green wood
  double leaf_mass = 0.5;       ///< kg a square metre of leaves
  double deadwood = 2;          ///< cycles that a dead twig stays on the tree; thicker wood stays longer
};

/// How a species of tree grows. Lengths in metres, angles in radians. Times are in growth cycles, see age.h,
/// except those in years; in_cycles() converts these to cycles, as a grove needs them.
struct Species {
  double pace = 1;                             ///< cycles a year while it is young
  double youth = 50;                           ///< years, the end of that pace
  double internode = 0.10;                     ///< length of an ordinary one
  int longest_shoot = 7;                       ///< maximum number of internodes from one bud in a cycle
  int longest_branch_shoot = 0;                ///< the same on branches; 0: as on the stem
  double branching_angle = radians(48.0);      ///< between a shoot and the axis it leaves
  double angle_jitter = radians(8.0);          ///< random change of it, plus or minus
  double phyllotaxis = radians(137.5);         ///< from bud to bud round the axis
  double branch_phyllotaxis = radians(137.5);  ///< the same on branches; 180 degrees makes flat sprays
  int whorl = 0;                 ///< only that many last buds of a stem's shoot may sprout; 0: all
  double wander = radians(5.0);  ///< random bend from internode to internode

  Sharing sharing = Sharing::borchert_honda;
  double vigour = 2.6;              ///< internodes a cycle for each fully lit bud, before sharing
  double apical_control = 0.6;      ///< 0.45 bushy .. 0.6 .. 0.85 a leading stem
  double apical_control_old = 0.5;  ///< its value at maturity
  double branch_control = 0;        ///< added to it on branches
  double maturity = 18;             ///< years, the age of that

  double light_pull = 0.35;      ///< weight of the direction of most light
  double tropism = 0.35;         ///< of the stem: upward > 0, downward < 0
  double branch_tropism = 0.08;  ///< of branches
  double spread = 0;             ///< 0..1: how far branches are held level
  double droop = 0;              ///< downward pull per order of branching after the first

  double shade_tolerance = 0.6;  ///< 0 sheds what is shaded at once .. 1 keeps nearly all
  double leaf_area = 0.014;      ///< square metres of leaves on one internode
  int leaf_years = 2;            ///< how long an internode bears leaves
  int bud_years = 4;             ///< how long a bud may rest
  double clear_trunk = 1.5;      ///< metres of stem that lose their branches as the tree grows up
  double height = 30;            ///< metres; growth ends near it
  double dome = 0.8;             ///< weight of the width relative to the height: 0 flat tops .. 1 round ones
  double lifespan = 400;         ///< years until the tree dies of age
  double anchorage = 0;          ///< N m, the moment that its roots hold per kg of stem; 0: any

  Wood wood;

  /// The light per internode, averaged over a branch, below which the branch dies (Takenaka 1994).
  double least_light() const {
    double need = 1 - shade_tolerance;
    return 0.015 + 0.22 * need * need;
  }
};

}  // namespace frond
