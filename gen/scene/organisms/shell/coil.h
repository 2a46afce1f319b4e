#pragma once

#include "organisms/shell/shell.h"

namespace frond {

/// The growing edge, shared by all growth lines: each is this edge, rotated and scaled.
struct ShellEdge {
  struct At {
    double out = 0, up = 0;     ///< away from the axis, and along it; the outermost point is 1 from the axis
    double normal[2] = {1, 0};  ///< outward, in the plane of the edge
    double crest = 0;           ///< -1 in a groove of the ribs .. 1 on a rib; fades toward the hinge
    double away = 1;            ///< distance from the hinge, 0..1; 1 for snails
  };
  std::vector<At> at;   ///< the last equals the first
  double middle = 0.5;  ///< distance of its middle from the axis
};

ShellEdge shell_edge(const ShellParams& params);

/// A snail or one valve, in its own axes: the axis is y for a snail, whose tip is up, and z for a valve,
/// which is above y = 0, its margin toward +x. `grown`: radians of the spiral still to grow. `below`: the
/// other valve, mirrored; its ribs fit into the grooves of the first.
Surface shell_wall(const ShellParams& params, const ShellEdge& edge, double grown, bool below);

/// A point of a valve's margin, with the valves closed.
Vec3 shell_margin(const ShellParams& params, const ShellEdge& edge, const ShellEdge::At& at, double grown,
                  bool below);

/// The tissue between the margins, opened by `gape` radians round a hinge at x.
Surface shell_mantle(const ShellParams& params, const ShellEdge& edge, double grown, double gape,
                     float hinge);

}  // namespace frond
