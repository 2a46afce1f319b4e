#pragma once

#include "appearance/skin.h"
#include "core/seed.h"
#include "model/skeleton.h"
#include "motion/motion.h"

namespace frond {

/// A sea fan: a net in one plane, whose threads join toward the foot.
struct FanParams {
  double across = 0.7;     ///< metres
  double height = 0.65;    ///< metres
  double mesh = 0.013;     ///< metres, about the width of an opening in the net
  double ragged = 0.4;     ///< unevenness of its outline
  double links = 0.65;     ///< share of the cross links that exist
  double thread = 0.0018;  ///< metres, radius of the thinnest
  double foot = 0.011;     ///< metres, radius at the foot
  double gather = 2.4;     ///< exponent of da Vinci's rule: r^n is conserved where threads join
  double curl = 0.03;      ///< metres that it bends out of its plane
  Skin skin;
  Wave wave;
  Food food;
  Growth growth;
};

/// Grows one with its foot at the origin, upright, across x. Every node has its distance, birth and radius.
Skeleton grow_fan(const FanParams& params, Seed seed);

}  // namespace frond
