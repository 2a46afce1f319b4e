#pragma once

#include "core/vec.h"

namespace frond {

/// How something that takes a time begins and ends.
enum class Ease {
  none,  ///< at an even pace
  in,    ///< slow at the beginning
  out,   ///< slow at the end
  both   ///< slow at both
};

/// The share 0..1 that is done of it when a share 0..1 of its time has passed: 0 at 0, 1 at 1, never less
/// than before.
inline double eased(Ease ease, double time) {
  switch (ease) {
    case Ease::none:
      return time;
    case Ease::in:
      return time * time;
    case Ease::out:
      return time * (2 - time);
    case Ease::both:
      return smooth_step(0.0, 1.0, time);
  }
  return time;
}

}  // namespace frond
