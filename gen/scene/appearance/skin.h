#pragma once

#include "appearance/color_shift.h"
#include "core/vec.h"
#include "model/solid.h"

namespace frond {

/// Pores in the skin of a coral.
struct Pores {
  double cell = 0.018;  ///< metres from pore to pore
  double warp = 0.25;   ///< 0 regular .. 1 strongly warped cells
  double depth = 0.8;   ///< apparent depth, 0 none
};

/// Colours of a coral.
struct Tint {
  Color base{0.85f, 0.45f, 0.35f};       ///< of the walls between the pores
  Color secondary{0.45f, 0.14f, 0.14f};  ///< in the pores
  ColorCourse course;                    ///< of both
  double variation = 0.15;               ///< variation of brightness between corals
  double young = 0.6;                    ///< how much paler growing tips are, 0..1
  double young_length = 0.08;            ///< metres from a tip over which the paleness fades
};

enum class SkinKind {
  stony,  ///< raised cups with a pit in each, walls between
  fan,    ///< fine and matt, as on sea fans and whips
  soft    ///< furry with open polyps
};

struct Skin {
  SkinKind kind = SkinKind::stony;
  Pores pores;
  Tint tint;
  Polyps polyps;
};

}  // namespace frond
