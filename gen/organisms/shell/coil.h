#pragma once

#include "organisms/shell/shell.h"

namespace frond {

/// The growing edge, once for all lines of growth: each is this, turned and sized.
struct ShellEdge {
  struct At {
    double out = 0, up = 0;     ///< from the axis, along it; the outermost is 1 from the axis
    double normal[2] = {1, 0};  ///< out of the edge, in its plane
    double crest = 0;           ///< -1 in a groove of the ribs .. 1 on a rib; fades toward the hinge
    double away = 1;            ///< from the hinge, 0..1; of snails 1
  };
  std::vector<At> at;   ///< the last is the first once more
  double middle = 0.5;  ///< of it, from the axis
};

ShellEdge shell_edge(const ShellParams& params);

/// A snail or one valve, in a frame of its own: the axis is y for a snail, whose tip is up, and z for a
/// valve, which lies above y = 0, its margin toward +x. `grown`: radians of the spiral that are still to
/// come. `below`: the other valve, mirrored; its ribs lie in the grooves of the first.
Surface shell_wall(const ShellParams& params, const ShellEdge& edge, double grown, bool below);

/// A place of the margin of a valve, before it is opened.
Vec3 shell_margin(const ShellParams& params, const ShellEdge& edge, const ShellEdge::At& at, double grown,
                  bool below);

/// The tissue between the margins, which are so far open, radians, round a hinge at x.
Surface shell_mantle(const ShellParams& params, const ShellEdge& edge, double grown, double gape,
                     float hinge);

}  // namespace frond
