#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "dynamics/stand.h"
#include "scene/scene.h"

namespace frond {

/// The years of a stand that a film shows.
struct StandFilm {
  double from = 0, to = 1;  ///< years
  double length = 1;        ///< seconds

  double time(double year) const { return length * (year - from) / std::max(1e-6, to - from); }  ///< seconds
};

/// Draws the trees of a preset's stand over its years as copies that come, grow, die, fall and rot: adds to
/// `scene.stands`. Each of its species has a library: the organism that it names, its
/// models, grown to the ages at which trees of the stand reach a few heights, alive and dead, and fitted to
/// what such trees measure there on average. A tree goes through them as it grows taller. Its copies are
/// scaled so that height and crown are those of the tree at any time, also where one takes over from another.
/// What is sown below the trees shows in the years in which the shade suits it.
void draw_stand(Scene& scene, const Preset& preset, const Grounds& ground, const StandHistory& history);

}  // namespace frond
