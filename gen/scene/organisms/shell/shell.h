#pragma once

#include <optional>
#include <vector>

#include "appearance/shell_look.h"
#include "core/curve.h"
#include "model/model.h"
#include "motion/motion.h"

// Shells
// ======
// A mollusc adds to its shell only at the edge, and each addition is slightly larger than the last: the edge,
// a closed curve, winds round an axis, grows by a constant factor per whorl and moves along the axis in
// proportion, a logarithmic helico-spiral (Raup 1966; Fowler, Meinhardt and Prusinkiewicz 1992). The same
// holds for snails and, with a factor of hundreds or millions, for the valves of a clam, which end before
// half a whorl.

namespace frond {

enum class ShellForm {
  univalve,  ///< coiled, as snails and nautilus
  bivalve,   ///< two valves on one hinge
  valve      ///< a single valve
};

/// Relief along the growth: cords of a snail, ribs or folds of a valve.
struct ShellRibs {
  int count = 0;         ///< round the edge; 0: none
  double height = 0.03;  ///< as a share of the last whorl's radius
  double broad = 1;      ///< below 1 narrow ribs between broad grooves, above 1 the reverse
};

/// Relief across the growth.
struct ShellCostae {
  int count = 0;  ///< per whorl of a snail; on a valve from its beak to its margin
  double height = 0.03;
  double sharp = 1;  ///< 1 round; higher values are narrower
};

/// Scales on the ribs: scutes, spines.
struct ShellScutes {
  int count = 0;  ///< as of costae
  double height = 0.08;
};

struct MantleParams {
  MantleLook look;
  double swell = 0.14;   ///< height above the margins, as a share of the valves' height
  double ruffle = 0.03;  ///< amplitude of its wavy edge, the same
};

struct ShellParams {
  ShellForm form = ShellForm::univalve;
  double size = 0.06;        ///< metres, its longest side, closed
  double expansion = 1.6;    ///< W: growth factor per whorl
  double distance = 0.1;     ///< D: distance of the edge from the axis, inner by outer
  double translation = 1.6;  ///< T: movement along the axis relative to the distance from it
  double aspect = 1;         ///< S: height of the edge relative to its width
  double whorls = 6;
  std::vector<Vec2> edge;  ///< the edge itself, in place of D and S: distances from the axis and along it
  double wall = 0.05;      ///< thickness, as a share of the last whorl's radius
  double flare = 0;        ///< how far the lip is turned out, the same
  double hollow = 0.5;     ///< depth of the opening, in whorls
  ShellRibs ribs;
  ShellCostae costae;
  ShellScutes scutes;
  Animated<double> gape{0.0};  ///< degrees between the valves
  std::optional<MantleParams> mantle;
  double tilt = radians(90.0);  ///< of the axis, or of the valves, from the vertical
  double roll = 0;              ///< about the axis
  double detail = 50000;        ///< triangles, about
  ShellLook look;
  Growth growth;

  bool coiled() const { return form == ShellForm::univalve; }
  /// Its growth rate: a factor of e to this power per radian.
  double rate() const;
};

/// Growth lines per cell of its edge that make both equally long.
double lines_a_cell(const ShellParams& params);

/// The picture of the shell.
Drawing shell_drawing_of(const ShellParams& params);

/// The shell at a share of its final size, 0..1, with the valves opened by `gape`; it stands on the origin. A
/// pure function of the parameters except for its brightness.
Model grow_shell(const ShellParams& params, double share, double gape, Seed seed);

}  // namespace frond
