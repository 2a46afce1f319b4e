#pragma once

#include "motion/motion.h"
#include "settings/scene_setup.h"

namespace frond {

/// Frames of a film, with the last.
struct FilmPart {
  int first = 1, last = 1;

  int count() const { return last - first + 1; }
};

/// How many frames' worth of an organism is not drawn in a part of a film, as it has not grown there yet.
double frames_ungrown(const Film& film, const Growth& growth, FilmPart part);

}  // namespace frond
