#pragma once

#include "core/vec.h"
#include "preset/describe.h"

namespace frond {

/// Jerlov's optical types of sea water (1976): I to III are oceans, 1C to 5C coasts, from clear to turbid.
enum class WaterType { I, IA, IB, II, III, coast1, coast3, coast5 };

/// The doc says how far one sees black things in it, which is four times the inverse of the attenuation
/// (Duntley 1963).
inline constexpr Choice<WaterType> kWaterTypes[] = {
    {"I", WaterType::I, "the clearest ocean; one sees about 50 m"},
    {"IA", WaterType::IA, "very clear ocean; about 35 m"},
    {"IB", WaterType::IB, "clear ocean; about 20 m"},
    {"II", WaterType::II, "ocean with plankton; about 15 m"},
    {"III", WaterType::III, "greenish sea; about 10 m"},
    {"1C", WaterType::coast1, "clear green coast; about 7 m"},
    {"3C", WaterType::coast3, "green coast; about 5 m"},
    {"5C", WaterType::coast5, "turbid coast; about 3 m"}};

/// How a camera sees through a water, by the spectra of the water and of the daylight that is left at a
/// depth, weighted by what its red, green and blue see. So things and the veil before them fade by different
/// coefficients (Akkaynak and Treibitz 2018): most of the red that is left of daylight is that which water
/// takes least of. Colours are linear.
struct WaterOptics {
  Vec3 direct{0};         ///< attenuation of the light that comes from things, 1/m
  Vec3 backscatter{0};    ///< 1/m by which the veil closes: veil * (1 - exp(-backscatter * distance))
  Vec3 veil{0};           ///< b E / c, the colour of endless water; 1 where all light is scattered
  Vec3 passed{1};         ///< colour of the daylight that is left at the depth, white above
  Vec3 metered{1};        ///< the same as the camera's sensor sees it, by which its white balance goes
  double scattering = 0;  ///< at 550 nm, 1/m
};

/// `depth`: metres below the surface at which things are lit.
WaterOptics water_optics(WaterType type, double depth);

}  // namespace frond
