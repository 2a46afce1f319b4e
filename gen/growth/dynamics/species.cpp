#include <algorithm>
#include <array>
#include <cmath>

#include "dynamics/stand.h"

namespace frond {

namespace {

using enum SeedCarrier;

// height, rate, shape: fitted to top heights at 20, 50 and 100 years of good sites: Forestry Commission yield
//   classes (Edwards and Christie 1981) 6 of oak, 10 of Scots pine, 8 of beech, 16 of Norway spruce, 8 of
//   birch; Schober 1975 I of beech and silver fir. Aspen, rowan: Leuschner and Ellenberg 2017.
// girth_gain: Mitchell's rule of 2.5 cm (White 1998), more for aspen and spruce, less for rowan.
// crown: crown diameters over diameters of Hemery, Savill and Pryor 2005; conifers: Hasenauer 1997.
// tolerance: Niinemets and Valladares 2006. lifespan: Leuschner and Ellenberg 2017, of natural stands.
// density: of fresh volume, Zanne et al. 2009. decay: Rock, Badeck and Harmon 2008; Herrmann et al. 2015.
// anchorage: Nicoll et al. 2006 for conifers; oak and beech hold more (Stokes 2002, Peltola 2006).
// reach: birch, pine, spruce: Vittoz and Engler 2007; jays: Gomez 2003; beech: Millerón et al. 2013.
// litter, wood: Bače et al. 2012 (spruce and rowan on logs), Leuschner and Ellenberg 2017.
// coldest: tree lines at 6.4 degrees (Körner and Paulsen 2004), less hardy kinds by their limits in altitude.
// clang-format off
constexpr std::array<TreeSpecies, 8> kSpecies{{
    //                  height  rate  shape girth  diam. crown      leaves
    {TreeName::birch,   26, 0.032, 1.1,  2.5, 0.6, 0.6, 8.0, 2.5,
    // shade life  wood  roots  evergreen rots
       2.0,   95,  525,  150,   false,   0.09,
    // seeds: carrier, reach, from age, amount, arriving, in litter, on wood
       wind,    45, 12, 3.0, 0.10,  0.05, 0.15,
    // coldest, moisture
       6.4,  0.50, 0.50},
    {TreeName::aspen,   28, 0.034, 1.15, 3.0, 0.8, 0.6, 7.5, 2.5,
       2.2,  105,  380,  130,   false,   0.09,
       wind,   100, 15, 1.0, 0.05,  0.03, 0.10,
       7.5,  0.60, 0.35},
    {TreeName::rowan,   15, 0.045, 1.1,  1.6, 0.4, 0.5, 10., 2.5,
       2.7,   85,  600,  160,   false,   0.08,
       animals, 60, 10, 0.5, 0.02,  0.50, 0.40,
       6.4,  0.50, 0.50},
    {TreeName::oak,     30, 0.018, 1.15, 2.5, 1.6, 0.7, 9.0, 3.5,
       2.6,  400,  560,  200,   false,   0.03,
       animals, 30, 40, 0.1, 0.02,  0.90, 0.10,
       10.,  0.50, 0.50},
    {TreeName::pine,    30, 0.024, 1.35, 2.3, 1.0, 0.5, 6.5, 2.5,
       1.7,  280,  420,  140,   true,    0.035,
       wind,    25, 20, 0.5, 0.06,  0.10, 0.15,
       6.8,  0.35, 0.50},
    {TreeName::beech,   38, 0.018, 1.4,  2.5, 1.3, 0.7, 9.0, 5.0,
       4.6,  260,  585,  170,   false,   0.09,
       gravity,  8, 45, 0.6, 0.004, 1.00, 0.20,
       9.0,  0.50, 0.30},
    {TreeName::spruce,  40, 0.021, 1.5,  2.8, 1.2, 0.4, 6.0, 5.0,
       4.45, 260,  380,  120,   true,    0.04,
       wind,    20, 35, 1.2, 0.04,  0.12, 1.00,
       6.8,  0.60, 0.30},
    {TreeName::fir,     42, 0.018, 1.7,  2.5, 1.5, 0.7, 6.0, 5.0,
       4.6,  320,  370,  150,   true,    0.045,
       wind,    15, 40, 0.4, 0.008, 0.60, 0.60,
       8.5,  0.55, 0.30},
}};
// clang-format on

constexpr std::array<std::string_view, 8> kNames{"birch", "aspen", "rowan",  "oak",
                                                 "pine",  "beech", "spruce", "fir"};

/// The root of 1 - (1 + x) exp(-x) = q, the share of a plane's exponential kernel within x scales.
double exponential_radius(double q) {
  double x = std::sqrt(2 * q) + q;
  for (int i = 0; i < 8; ++i) {
    double e = std::exp(-x);
    x = std::max(x - (1 - (1 + x) * e - q) / std::max(x * e, 1e-12), 0.0);
  }
  return x;
}

constexpr double kMedianExponential = 1.67834699;  // exponential_radius(0.5)
constexpr double kMostYears = 1000;                // of an age that is told by height
constexpr double kMostShare = 0.9999;              // of seeds, since the last ones of a tail lie anywhere

}  // namespace

std::span<const TreeSpecies> tree_species() { return kSpecies; }

std::string_view name_of(TreeName name) { return kNames[static_cast<std::size_t>(name)]; }

double height_at(const TreeSpecies& species, double age) {
  return species.height * std::pow(1 - std::exp(-species.rate * age), species.shape);
}

double age_at(const TreeSpecies& species, double height) {
  double share = std::pow(std::min(height / species.height, 1.0), 1 / species.shape);
  return share < 1 ? std::min(-std::log(1 - share) / species.rate, kMostYears) : kMostYears;
}

double seed_distance(const TreeSpecies& species, double q) {
  q = std::clamp(q, 0.0, kMostShare);
  switch (species.carrier) {
    case SeedCarrier::wind:  // 1 - (1 + r2/u)^-1 = q, whose median is the root of u
      return species.reach * std::sqrt(q / (1 - q));
    case SeedCarrier::gravity:
      return species.reach * std::sqrt(-std::log(1 - q) / std::log(2.0));
    case SeedCarrier::animals:
      return species.reach * exponential_radius(q) / kMedianExponential;
  }
  return 0;
}

}  // namespace frond
