#pragma once

#include <vector>

#include "appearance/health.h"
#include "appearance/skin.h"
#include "core/seed.h"
#include "model/solid.h"

// What shows of the health of corals and sponges.
//
// As in mass bleaching (Glynn 1993, Hughes et al. 2017), tissue pales as it loses its algae; that of some
// fluoresces just before (Bollati et al. 2020). White colonies live on for weeks: they take their colour
// back, or they die and are soon under turf, which does not give way again.

namespace frond {

/// What of a colony's tissue has paled and is dead, and how it glows.
struct Bleached {
  float pale = 0;  ///< share, 0..1: 1 white, at half its health
  float dead = 0;  ///< share, 0..1, under turf
  float glow = 0;  ///< that comes to its own, see Polyps
};
Bleached bleached_at(const Health& health, const Fare& fare);

/// What the skin of a coral turns to, as it is at the beginning of a film, see skin_at().
Skin skin_in(const Skin& skin, const Bleached& bleached);

/// What the material of a living body turns to; other materials stay.
Material material_in(const Material& material, const Bleached& bleached);

/// Patches that turf spreads from over a skin, as large as they come to be, which covers it.
std::vector<DeadPatch> turf_on(const Surface& skin, Seed seed);

/// Patches on a skin of which the share `dead` has died: those that it had before, and of the turf as much as
/// there is by then.
std::vector<DeadPatch> turf_at(const std::vector<DeadPatch>& own, const std::vector<DeadPatch>& turf,
                               float dead);

}  // namespace frond
