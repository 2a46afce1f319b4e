#pragma once

#include <optional>
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

/// What a picture of bark shows.
enum class BarkPattern {
  furrowed,  ///< long ridges with half-round backs that run into each other, as on oaks
  plated,    ///< plates between cracks, as on pines
  smooth,    ///< a skin with folds and short scars across, as on beeches and aspens
  banded     ///< papery, with dark bands across, as on birches
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

/// How the bark of one branch differs from that of the plant; what is not given is the plant's.
struct BarkChange {
  std::optional<BarkKind> kind = {};
  std::optional<Color> color = {}, second = {};
  std::optional<BarkPattern> pattern = {};  ///< of its picture, where the plant wears one
  std::optional<double> lichens = {};       ///< share of it that lichens cover, 0..1
};

}  // namespace frond
