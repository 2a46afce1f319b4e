#pragma once

#include <vector>

#include "core/curve.h"
#include "core/vec.h"

namespace frond {

/// How something that lives fares over a film.
struct Health {
  Animated<double> at{1.0};      ///< 1 healthy .. 0 dead
  double stagger = 0;            ///< seconds: individuals follow later by a random delay of at most this
  std::vector<Color> colors;     ///< of leaves on their way, the last that of dead ones; empty: as is usual
  double sheds = 0;              ///< health below which leaves fall; 0: they stay on the plant
  double droop = radians(55.0);  ///< radians by which leaves and flowers hang down when they are dead
  double fluoresces = 0;         ///< of corals, the glow of colonies that are about to pale, see Polyps

  /// Whether it is always healthy.
  bool plain() const { return at.constant() && at.at(0) == 1; }
};

/// How one fares at a time.
struct Fare {
  float now = 1;    ///< 1 healthy .. 0 dead
  float least = 1;  ///< the worst that it has been through so far: what has died does not come back
};

/// At a time in seconds; `delay`: seconds that it follows later.
Fare fare_at(const Health& health, double time, double delay = 0);

}  // namespace frond
