#pragma once

#include "model/surface.h"

namespace frond {

/// The shapes of ivy leaves (Hedera helix) as a shoot ages.
enum class IvyForm {
  arrow,  ///< of young runners: five lobes, the middle one long
  five,   ///< of creeping shoots: five lobes
  three,  ///< older: three shallow lobes
  heart   ///< of adult shoots in the light: no lobes
};
inline constexpr int kIvyForms = 4;

struct IvyLeafShape {
  IvyForm form = IvyForm::five;
  double stalk = 0.8;           ///< length of the petiole as a share of the blade's
  double rise = radians(50.0);  ///< between the petiole and the plane of the blade
  double droop = 0.2;           ///< how far lobes hang, as a share of the blade's length
  double wave = 0.035;          ///< how much the blade bulges between the veins
  int detail = 2;               ///< 0: an outline of a dozen corners .. 2: smooth, with sunken veins
};

/// A leaf with its petiole. The foot of the petiole is at the origin; the blade is one unit long, points
/// along +y with the upper side toward +z, and begins at ivy_attachment().
///
/// `uv` of the blade refer to a leaf whose lobes point at 0, 50 and 110 degrees, whatever the form, so that
/// one texture has the veins of all: u = 0.5 + x / 2.6, v = 0.5 + y / 2.6, the blade's foot at the middle. On
/// the petiole u is 2 at its foot .. 3 at the blade.
Surface ivy_leaf_surface(const IvyLeafShape& shape);

/// Where petiole and blade meet.
Vec3 ivy_attachment(const IvyLeafShape& shape);

/// Distance of the rim from the blade's foot in a direction, radians from the tip, left or right.
double ivy_rim(IvyForm form, double angle);

/// The middle of the blade and the radius of a circle of the same area.
struct LeafDisc {
  Vec3 middle{0};
  float radius = 0;
};
LeafDisc ivy_disc(const IvyLeafShape& shape);

}  // namespace frond
