#pragma once

#include <vector>

#include "model/surface.h"

namespace frond {

enum class TrellisForm {
  wires,    ///< posts with level wires before them, as for espaliers and vines
  lattice,  ///< laths upright and level, crossing each other
  fan       ///< laths that spread from the foot, and level ones across them
};

/// What climbing and trained plants are tied to, along x: the middle of its foot at the origin, its front
/// toward +z. Metres.
struct TrellisShape {
  TrellisForm form = TrellisForm::wires;
  double width = 4, height = 2;
  int posts = 3;          ///< of wires, at equal distances, the first and last at its ends; 2 or more
  double post = 0.08;     ///< their width
  int wires = 4;          ///< evenly from `lowest` to 0.1 m below the height; or level laths of a fan
  double lowest = 0.45;   ///< height of the lowest of them
  double wire = 0.004;    ///< thickness
  double sag = 0.006;     ///< of a wire in the middle between two posts
  double spacing = 0.25;  ///< of the laths of a lattice
  int rays = 7;           ///< number of the laths of a fan
  double lath = 0.03;     ///< width of a lath; it is half as thick
};

/// One post, lath or wire, closed. Of timber the grain runs along x in its own space.
struct TrellisPart {
  bool wire = false;
  Surface surface;
  Vec3 at{0};
  Quat turn{1, 0, 0, 0};
};

/// Wires run 2 wires' thickness before the posts, level laths before the upright ones.
std::vector<TrellisPart> trellis_parts(const TrellisShape& shape);

}  // namespace frond
