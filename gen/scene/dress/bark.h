#pragma once

#include <vector>

#include "core/vec.h"

namespace frond {

enum class BarkKind {
  bark,   ///< furrowed
  birch,  ///< white with dark bands
  stem,   ///< green and smooth
  ink,    ///< one matt colour
  metal,  ///< polished wire
  wax,    ///< smooth and bright, for curves in colour
  palm    ///< rings across the branch, the scars of leaves
};

/// The surface of branches.
struct Bark {
  BarkKind kind = BarkKind::bark;
  std::vector<Color> colors{{0.42f, 0.33f, 0.25f}};  ///< selected cyclically by the turtle's colour index
  Color second{0.20f, 0.15f, 0.11f};                 ///< in furrows, in bands
  double scale = 0.04;                               ///< metres, width of a furrow
  double depth = 0.6;                                ///< of the relief
  Color young{0.36f, 0.46f, 0.18f};                  ///< of young shoots
  double young_length = 0;                           ///< metres below a tip that are young
  double variation = 0.08;                           ///< variation of brightness between plants
};

}  // namespace frond
