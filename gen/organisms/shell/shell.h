#pragma once

#include <optional>
#include <vector>

#include "core/curve.h"
#include "core/result.h"
#include "dress/shell_look.h"
#include "model/model.h"
#include "motion/motion.h"

// Shells
// ======
// A mollusc adds to its shell at the edge alone, and each addition is a little larger than the last: the
// edge, a closed curve, winds round an axis, grows by one factor each whorl and moves along the axis by as
// much, a logarithmic helico-spiral (Raup 1966; Fowler, Meinhardt and Prusinkiewicz 1992). The same holds for
// snails and, with a factor of hundreds or millions, for the valves of a clam, which end before half a whorl.

namespace frond {

enum class ShellForm {
  univalve,  ///< coiled, as snails and nautilus
  bivalve,   ///< two valves on one hinge
  valve      ///< one of them
};

/// What stands on a shell along its growth: cords of a snail, ribs or folds of a valve.
struct ShellRibs {
  int count = 0;         ///< round the edge; 0: none
  double height = 0.03;  ///< as a share of the last whorl's radius
  double broad = 1;      ///< below 1 narrow ribs between broad grooves, above 1 the other way round
};

/// What stands on it across its growth.
struct ShellCostae {
  int count = 0;  ///< on a whorl of a snail; on a valve from its beak to its margin
  double height = 0.03;
  double sharp = 1;  ///< 1 round; more make them narrow
};

/// Scales that rise on the ribs: scutes, spines.
struct ShellScutes {
  int count = 0;  ///< as of costae
  double height = 0.08;
};

struct MantleParams {
  MantleLook look;
  double swell = 0.14;   ///< how far it rises over the margins, as a share of the valves' height
  double ruffle = 0.03;  ///< how far its edge undulates, the same
};

struct ShellParams {
  ShellForm form = ShellForm::univalve;
  double size = 0.06;        ///< metres, its longest side, closed
  double expansion = 1.6;    ///< W: by how much it grows in a whorl
  double distance = 0.1;     ///< D: of the edge from the axis, inner by outer
  double translation = 1.6;  ///< T: along the axis, by distance from it
  double aspect = 1;         ///< S: height of the edge by its width
  double whorls = 6;
  std::vector<Vec2> edge;  ///< the edge itself, in place of D and S: from the axis, along it
  double wall = 0.05;      ///< thickness, as a share of the last whorl's radius
  double flare = 0;        ///< how far the lip turns out, the same
  double hollow = 0.5;     ///< whorls that the inside goes back
  ShellRibs ribs;
  ShellCostae costae;
  ShellScutes scutes;
  Animated<double> gape{0.0};  ///< degrees between the valves
  std::optional<MantleParams> mantle;
  double tilt = radians(90.0);  ///< of the axis, or of the valves, from plumb
  double roll = 0;              ///< about the axis
  double detail = 50000;        ///< triangles, about
  ShellLook look;
  Growth growth;

  bool coiled() const { return form == ShellForm::univalve; }
  /// The rate of its growth: by e to this a radian.
  double rate() const;
};

/// How many lines of growth there are for each cell of its edge, were both of one length.
double lines_a_cell(const ShellParams& params);

/// Its picture.
Drawing shell_drawing_of(const ShellParams& params);

/// The shell when it has come to a share of its size, 0..1, with its valves so far apart; it stands on the
/// origin. A pure function of the parameters but for its brightness.
Model grow_shell(const ShellParams& params, double share, double gape, Seed seed);

}  // namespace frond
